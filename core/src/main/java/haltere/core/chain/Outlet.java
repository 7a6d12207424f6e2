package haltere.core.chain;

import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;

/**
 * Publishes a filter's results of one type. Results are immutable. Results for tables are records
 * whose component names are the column names, units included.
 *
 * <p>Thread rule: {@link #publish} runs on the processing thread and calls the subscribers there,
 * so they must be quick; subscribing is allowed from any thread.
 *
 * @param <T> type of the results
 * @since 0.1
 */
public final class Outlet<T> {
  /** Ends a subscription. */
  public interface Subscription extends AutoCloseable {
    @Override
    void close();
  }

  private final String name;
  private final Class<T> type;
  private final Optional<ResultOrder<T>> order;
  private final CopyOnWriteArrayList<OutletSubscription> listeners = new CopyOnWriteArrayList<>();
  private boolean runUp;

  /**
   * An outlet.
   *
   * @param name lower case words joined by hyphens, unique within the filter
   * @param type class of the results
   */
  public Outlet(String name, Class<T> type) {
    this(name, type, Optional.empty());
  }

  /**
   * An outlet whose results are published out of order.
   *
   * @param name lower case words joined by hyphens, unique within the filter
   * @param type class of the results
   * @param order of the results in a table; empty if it is that of publication
   */
  public Outlet(String name, Class<T> type, Optional<ResultOrder<T>> order) {
    this.name = Objects.requireNonNull(name, "name");
    this.type = Objects.requireNonNull(type, "type");
    this.order = Objects.requireNonNull(order, "order");
  }

  /**
   * The outlet's name.
   *
   * @return unique within its filter
   */
  public String name() {
    return name;
  }

  /**
   * The type of the results.
   *
   * @return a class
   */
  public Class<T> type() {
    return type;
  }

  /**
   * The order in which a table has the results.
   *
   * @return empty where they are published in order
   */
  public Optional<ResultOrder<T>> order() {
    return order;
  }

  /**
   * Whether there are subscribers; without them a filter need not create results.
   *
   * @return true with at least one subscriber
   */
  public boolean hasSubscribers() {
    return !listeners.isEmpty();
  }

  /**
   * Subscribes to results, except during a run-up, whose events are repeated. A subscriber that
   * throws is removed with a line in the log of this class; the filter continues.
   *
   * @param subscriber called on the processing thread for each result
   * @return ends the subscription when closed
   */
  public Subscription subscribe(Consumer<? super T> subscriber) {
    return listen(subscriber, this::log, false);
  }

  /**
   * Subscribes to results as {@link #subscribe(Consumer)}, with a callback on failure.
   *
   * @param subscriber called on the processing thread for each result
   * @param failed receives what the subscriber threw, on the processing thread; must not throw
   * @return ends the subscription when closed
   */
  public Subscription subscribe(
      Consumer<? super T> subscriber, Consumer<? super RuntimeException> failed) {
    return listen(subscriber, failed, false);
  }

  /**
   * Subscribes to results also during a run-up, for a subscriber that shows only the newest one.
   *
   * @param subscriber called on the processing thread for each result
   * @return ends the subscription when closed
   */
  public Subscription follow(Consumer<? super T> subscriber) {
    return listen(subscriber, this::log, true);
  }

  private Subscription listen(
      Consumer<? super T> subscriber, Consumer<? super RuntimeException> failed, boolean inRunUps) {
    OutletSubscription listener =
        new OutletSubscription(
            Objects.requireNonNull(subscriber, "subscriber"),
            Objects.requireNonNull(failed, "failed"),
            inRunUps);
    listeners.add(listener);
    return listener;
  }

  private void log(RuntimeException thrown) {
    System.getLogger(Outlet.class.getName())
        .log(
            System.Logger.Level.ERROR,
            () -> "a subscriber of " + name + " failed and gets no more results",
            thrown);
  }

  void setRunUp(boolean on) {
    runUp = on;
  }

  /**
   * Passes a result to all subscribers, during a run-up to those of {@link #follow}.
   *
   * @param result immutable
   */
  public void publish(T result) {
    for (OutletSubscription listener : listeners) {
      if (listener.inRunUps || !runUp) {
        listener.take(result);
      }
    }
  }

  /** One subscription; the same subscriber may have several. */
  private final class OutletSubscription implements Subscription {
    final Consumer<? super T> subscriber;
    final Consumer<? super RuntimeException> failed;
    final boolean inRunUps;

    OutletSubscription(
        Consumer<? super T> subscriber,
        Consumer<? super RuntimeException> failed,
        boolean inRunUps) {
      this.subscriber = subscriber;
      this.failed = failed;
      this.inRunUps = inRunUps;
    }

    void take(T result) {
      try {
        subscriber.accept(result);
      } catch (RuntimeException thrown) {
        close();
        failed.accept(thrown);
      }
    }

    @Override
    public void close() {
      listeners.remove(this);
    }
  }
}
