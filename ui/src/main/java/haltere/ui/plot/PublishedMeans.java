package haltere.ui.plot;

import haltere.core.chain.FilterChain;
import haltere.core.chain.Outlet;
import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Averages all numbers that a chain publishes, also in run-ups, for the comparison of two chains.
 *
 * <p>Thread rule: everything on the processing thread of the chain.
 */
public final class PublishedMeans implements AutoCloseable {
  private final Map<PlotField, DoubleSummaryStatistics> numbers = new LinkedHashMap<>();
  private final List<Outlet.Subscription> subscriptions = new ArrayList<>();

  /** Subscribes to all outlets of a chain. */
  public PublishedMeans(FilterChain chain) {
    for (PlotField field : PlotField.of(chain)) {
      numbers.put(field, new DoubleSummaryStatistics());
      field
          .listen(chain, true, (timeUs, key, value) -> add(field, value))
          .ifPresent(subscriptions::add);
    }
  }

  private void add(PlotField field, double value) {
    if (Double.isFinite(value)) {
      numbers.get(field).accept(value);
    }
  }

  /**
   * Means of results since the last call, in the order of the chain; without fields that had no
   * results.
   */
  public Map<PlotField, Double> take() {
    Map<PlotField, Double> means = new LinkedHashMap<>();
    numbers.forEach(
        (field, values) -> {
          if (values.getCount() > 0) {
            means.put(field, values.getAverage());
          }
        });
    numbers.replaceAll((field, values) -> new DoubleSummaryStatistics());
    return means;
  }

  /** Ends listening. */
  @Override
  public void close() {
    subscriptions.forEach(Outlet.Subscription::close);
    subscriptions.clear();
  }
}
