package haltere.ui.plot;

import haltere.core.chain.FilterChain;
import haltere.core.chain.Outlet;
import java.util.Optional;

/**
 * Subscribes to a field of a running chain, including run-ups, and stores its samples until the
 * window fetches them.
 *
 * <p>Thread rule: samples come on the processing thread; all else is for one other thread.
 *
 * @param field the subscribed field
 * @param queue samples that were not fetched yet
 * @param subscription ends listening
 */
public record PlotFeed(PlotField field, SampleQueue queue, Outlet.Subscription subscription)
    implements AutoCloseable {
  private static final int CAPACITY = 1 << 15;

  /**
   * Subscribes to a field, on the chain's processing thread or while it does not run; empty if the
   * chain does not publish it.
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
