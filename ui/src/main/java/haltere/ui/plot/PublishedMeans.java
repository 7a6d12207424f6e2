package haltere.ui.plot;

import haltere.core.chain.FilterChain;
import haltere.core.chain.Outlet;
import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.TreeMap;

/**
 * Averages all numbers that a chain publishes in a second of recording time, also in run-ups, for
 * the comparison of two chains.
 *
 * <p>Thread rule: everything on the processing thread of the chain.
 */
public final class PublishedMeans implements AutoCloseable {
  /** Results are dropped in parts of this time, microseconds. */
  private static final long PART_US = 100_000;

  private static final int PARTS = 10;

  private final Map<PlotField, NavigableMap<Long, DoubleSummaryStatistics>> numbers =
      new LinkedHashMap<>();
  private final FilterChain chain;
  private long newestPart = Long.MIN_VALUE / 2;
  private final List<Outlet.Subscription> subscriptions = new ArrayList<>();

  /** Subscribes to all outlets of a chain. */
  public PublishedMeans(FilterChain chain) {
    this.chain = chain;
    for (PlotField field : PlotField.of(chain)) {
      numbers.put(field, new TreeMap<>());
      field
          .listen(chain, true, (timeUs, key, value) -> add(field, timeUs, value))
          .ifPresent(subscriptions::add);
    }
  }

  /** The chain that publishes. */
  public FilterChain chain() {
    return chain;
  }

  private void add(PlotField field, long timeUs, double value) {
    if (Double.isFinite(value)) {
      long part = Math.floorDiv(timeUs, PART_US);
      if (part > newestPart) {
        newestPart = part;
        numbers.values().forEach(parts -> parts.headMap(part - PARTS, true).clear());
      }
      numbers.get(field).computeIfAbsent(part, at -> new DoubleSummaryStatistics()).accept(value);
    }
  }

  /**
   * Means of the results up to a second before the newest one, in the order of the chain; without
   * fields that had no results.
   */
  public Map<PlotField, Double> means() {
    Map<PlotField, Double> means = new LinkedHashMap<>();
    numbers.forEach(
        (field, parts) -> {
          DoubleSummaryStatistics all = new DoubleSummaryStatistics();
          parts.tailMap(newestPart - PARTS, false).values().forEach(all::combine);
          if (all.getCount() > 0) {
            means.put(field, all.getAverage());
          }
        });
    return means;
  }

  /** Ends listening. */
  @Override
  public void close() {
    subscriptions.forEach(Outlet.Subscription::close);
    subscriptions.clear();
  }
}
