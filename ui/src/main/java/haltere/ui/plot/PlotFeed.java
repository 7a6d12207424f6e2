package haltere.ui.plot;

import haltere.core.chain.FilterChain;
import haltere.core.chain.Outlet;
import java.util.Optional;

/**
 * Listens to a field of a running chain, during run-ups too, and keeps its samples until the window
 * takes them.
 *
 * <p>Thread rule: samples come on the processing thread; all else is for one other thread.
 *
 * @param field what it listens to
 * @param queue the samples that came and were not taken yet
 * @param subscription ends listening
 */
public record PlotFeed(PlotField field, SampleQueue queue, Outlet.Subscription subscription)
    implements AutoCloseable {
  private static final int CAPACITY = 1 << 15;

  /**
   * Starts to listen to a field, on the chain's processing thread or while it does not run; empty
   * where the chain does not publish it.
   */
  public static Optional<PlotFeed> open(PlotField field, FilterChain chain) {
    SampleQueue queue = new SampleQueue(CAPACITY);
    return field
        .listen(chain, true, queue::put)
        .map(subscription -> new PlotFeed(field, queue, subscription));
  }

  /** Ends listening. */
  @Override
  public void close() {
    subscription.close();
  }
}
