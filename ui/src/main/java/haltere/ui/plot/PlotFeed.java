package haltere.ui.plot;

import haltere.core.chain.FilterChain;
import haltere.core.chain.Outlet;
import java.util.Optional;

/**
 * Listens to a field of a running chain, during run-ups too, and keeps its samples until the window
 * takes them.
 *
 * <p>Thread rule: samples come on the processing thread; all else is for one other thread.
 */
public final class PlotFeed implements AutoCloseable {
  private static final int CAPACITY = 1 << 15;
  private final PlotField field;
  private final SampleQueue queue;
  private final Outlet.Subscription subscription;

  private PlotFeed(PlotField field, SampleQueue queue, Outlet.Subscription subscription) {
    this.field = field;
    this.queue = queue;
    this.subscription = subscription;
  }

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

  /** What it listens to. */
  public PlotField field() {
    return field;
  }

  /** Hands over the samples that came since the last call, oldest first. */
  public void drainTo(SampleQueue.SampleConsumer consumer) {
    queue.drainTo(consumer);
  }

  /** How many samples came faster than they were taken and are left out. */
  public long lost() {
    return queue.lost();
  }

  /** Ends listening. */
  @Override
  public void close() {
    subscription.close();
  }
}
