package haltere.ui.command.report;

import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterChain;
import haltere.core.chain.Outlet;
import haltere.filters.trail.TrailPoint;
import haltere.ui.command.terminal.Quantities;
import haltere.ui.plot.PlotRow;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;

/** The objects of a tracker as rows of a table, one for each identity, in bounded memory. */
final class ObjectTable {
  private static final int MAX_ROWS = 100;
  private static final int MAX_KEPT = 20_000;
  private static final List<String> HEADER =
      List.of(
          "identity",
          "first time (s)",
          "last time (s)",
          "duration (s)",
          "events",
          "mean speed (px/s)",
          "mean extent, length × width (px)");

  private static final class Summary {
    private final DoubleSummaryStatistics times = new DoubleSummaryStatistics();
    private final DoubleSummaryStatistics speeds = new DoubleSummaryStatistics();
    private final DoubleSummaryStatistics lengths = new DoubleSummaryStatistics();
    private final DoubleSummaryStatistics widths = new DoubleSummaryStatistics();
    private double events;
  }

  private final String heading;
  private final PlotRow columns;
  private final Map<Integer, Summary> objects = new TreeMap<>();

  private ObjectTable(String stage, Outlet<?> outlet) {
    String name = outlet.name();
    heading = name.substring(0, 1).toUpperCase(Locale.ROOT) + name.substring(1) + " of " + stage;
    columns = PlotRow.of(outlet.type()).orElseThrow();
    outlet.subscribe(row -> take((TrailPoint) row));
  }

  /** A table for each outlet of objects of a chain, which it subscribes to. */
  static List<ObjectTable> of(FilterChain chain) {
    List<ObjectTable> tables = new ArrayList<>();
    for (ChainStage stage : chain.innermostStages()) {
      for (Outlet<?> outlet : stage.filter().outlets()) {
        if (TrailPoint.class.isAssignableFrom(outlet.type())) {
          tables.add(new ObjectTable(stage.name(), outlet));
        }
      }
    }
    return tables;
  }

  private void take(TrailPoint row) {
    if (objects.size() < MAX_KEPT || objects.containsKey(row.id())) {
      Summary object = objects.computeIfAbsent(row.id(), absent -> new Summary());
      object.times.accept(row.timeUs());
      object.speeds.accept(Math.hypot(row.vxPxS(), row.vyPxS()));
      object.lengths.accept(2 * value(row, "major_px"));
      object.widths.accept(2 * value(row, "minor_px"));
      object.events = value(row, "events");
    }
  }

  private double value(TrailPoint row, String column) {
    int index = columns.index(column);
    return index < 0 ? Double.NaN : columns.value((Record) row, index);
  }

  /** Adds the table to a page, with times from the first event of the recording. */
  void addTo(ReportPage page, long firstUs) {
    page.section(heading);
    Collection<Integer> shown = objects.keySet();
    if (objects.size() > MAX_ROWS) {
      shown =
          objects.keySet().stream()
              .sorted(Comparator.comparingDouble(id -> -objects.get(id).events))
              .limit(MAX_ROWS)
              .sorted()
              .toList();
      boolean isAll = objects.size() < MAX_KEPT;
      page.sentence(
          Quantities.text(
              "The %d with the most events of %s%,d.",
              MAX_ROWS, isAll ? "" : "the first ", objects.size()));
    }
    boolean hasExtent = columns.index("major_px") >= 0;
    String extent = hasExtent ? " The extent is four standard deviations long and wide." : "";
    page.sentence(
        objects.isEmpty() ? "Nothing was tracked." : "Times count from the first event." + extent);
    if (!objects.isEmpty()) {
      int wide = HEADER.size() - (hasExtent ? 0 : 1);
      page.table(
          HEADER.subList(0, wide),
          shown.stream().map(id -> row(id, objects.get(id), firstUs).subList(0, wide)).toList());
    }
  }

  private static List<String> row(int id, Summary object, long firstUs) {
    double fromS = (object.times.getMin() - firstUs) * 1e-6;
    double toS = (object.times.getMax() - firstUs) * 1e-6;
    double length = object.lengths.getAverage();
    return List.of(
        Integer.toString(id),
        Quantities.text("%.3f", fromS),
        Quantities.text("%.3f", toS),
        Quantities.text("%.3f", toS - fromS),
        Quantities.text("%,.0f", object.events),
        Quantities.text("%.1f", object.speeds.getAverage()),
        Quantities.text("%.1f × %.1f", length, object.widths.getAverage()));
  }
}
