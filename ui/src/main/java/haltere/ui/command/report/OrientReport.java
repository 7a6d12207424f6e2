package haltere.ui.command.report;

import haltere.filters.orientation.OrientationEstimate;
import haltere.filters.orientation.OrientationSettings;
import haltere.ui.command.results.OrientationRow;
import haltere.ui.plot.PlotField;
import haltere.ui.plot.PlotRow;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
import java.util.stream.Stream;

/** Report of orientations: position, axis and deviation of each body over time. */
public final class OrientReport implements BiConsumer<String, OrientationEstimate> {
  private static final PlotRow ROW = PlotRow.of(OrientationRow.class).orElseThrow();

  private final List<ReportCurves> curves =
      Stream.of("x_m", "y_m", "z_m", "ux", "uy", "uz", "sd_axis_rad")
          .map(column -> new ReportCurves(List.of(new PlotField("", "orientation", column))))
          .toList();

  @Override
  public void accept(String object, OrientationEstimate now) {
    OrientationRow row = OrientationRow.of(object, now);
    for (ReportCurves curve : curves) {
      PlotField field = curve.fields().get(0);
      double value = ROW.value(row, ROW.index(field.column()));
      curve.take(field, now.timeUs(), object, value);
    }
  }

  /** Adds to a page the inputs by name, the estimator's settings, lines of text and the plots. */
  public void addTo(
      ReportPage page,
      Map<String, String> read,
      OrientationSettings settings,
      List<String> summary) {
    page.section("Input");
    page.facts(read);
    page.section("Settings that differ from their defaults");
    List<String> differing = ChainTable.differing(settings);
    page.text(differing.isEmpty() ? List.of("none") : differing);
    page.section("Results");
    page.text(summary);
    page.section("Plots");
    curves.forEach(curve -> curve.addTo(page, "time (s)"));
  }
}
