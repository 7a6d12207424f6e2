package haltere.ui.command.report;

import haltere.core.chain.Outlet;
import haltere.filters.orientation.OrientationEstimate;
import haltere.filters.orientation.OrientationSettings;
import haltere.ui.command.results.OrientationRow;
import haltere.ui.plot.PlotField;
import java.util.List;
import java.util.Map;
import java.util.function.BiConsumer;
import java.util.stream.Stream;

/** Report of orientations: position, axis and deviation of each body over time. */
public final class OrientReport implements BiConsumer<String, OrientationEstimate> {
  private final Outlet<OrientationRow> rows = new Outlet<>("orientation", OrientationRow.class);
  private final List<ReportCurves> curves =
      Stream.of("x_m", "y_m", "z_m", "ux", "uy", "uz", "sd_axis_rad")
          .map(column -> new PlotField("", rows.name(), column))
          .map(field -> new ReportCurves(field, rows, timeUs -> timeUs))
          .toList();

  @Override
  public void accept(String object, OrientationEstimate now) {
    rows.publish(OrientationRow.of(object, now));
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
