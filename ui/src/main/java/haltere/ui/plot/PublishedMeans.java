package haltere.ui.plot;

import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterChain;
import haltere.core.chain.Outlet;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Averages all numbers that a chain publishes, so that two chains can be compared.
 *
 * <p>Thread rule: everything on the processing thread of the chain.
 */
public final class PublishedMeans implements AutoCloseable {
  /** The columns of an outlet. */
  private static final class Table {
    private final String stage;
    private final String outlet;
    private final RowFields row;
    private final double[] sums;
    private final long[] counts;

    Table(String stage, String outlet, RowFields row) {
      this.stage = stage;
      this.outlet = outlet;
      this.row = row;
      sums = new double[row.columns().size()];
      counts = new long[row.columns().size()];
    }

    void add(Object result) {
      for (int column = 0; column < sums.length; column++) {
        double value = row.value(result, column);
        if (Double.isFinite(value)) {
          sums[column] += value;
          counts[column]++;
        }
      }
    }

    void takeInto(Map<PlotField, Double> means) {
      for (int column = 0; column < sums.length; column++) {
        if (counts[column] > 0) {
          means.put(
              new PlotField(stage, outlet, row.columns().get(column)),
              sums[column] / counts[column]);
        }
        sums[column] = 0;
        counts[column] = 0;
      }
    }
  }

  private final List<Table> tables = new ArrayList<>();
  private final List<Outlet.Subscription> subscriptions = new ArrayList<>();

  /** Listens to all that a chain publishes as it is now. */
  public PublishedMeans(FilterChain chain) {
    for (ChainStage stage : chain.stages()) {
      for (Outlet<?> outlet : stage.filter().outlets()) {
        RowFields.of(outlet.type())
            .ifPresent(
                row -> {
                  Table table = new Table(stage.name(), outlet.name(), row);
                  tables.add(table);
                  subscriptions.add(outlet.subscribe(table::add));
                });
      }
    }
  }

  /**
   * The means of what was published since the last call, in the order of the chain; without those
   * that nothing was published for.
   */
  public Map<PlotField, Double> take() {
    Map<PlotField, Double> means = new LinkedHashMap<>();
    tables.forEach(table -> table.takeInto(means));
    return means;
  }

  /** Ends listening. */
  @Override
  public void close() {
    subscriptions.forEach(Outlet.Subscription::close);
    subscriptions.clear();
  }
}
