package haltere.core.chain;

import java.util.Objects;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;

/**
 * Where a filter publishes results of one type. Results are immutable; where they are rows of a
 * table they are records whose component names are the column names, units included.
 *
 * <p>Thread rule: {@link #publish} runs on the processing thread and calls the subscribers there,
 * so they must be quick; subscribing is allowed from any thread.
 *
 * @param <T> type of the results
 */
public final class Outlet<T> {
  /** Ends a subscription. */
  public interface Subscription extends AutoCloseable {
    @Override
    void close();
  }

  private final String name;
  private final Class<T> type;
  private final CopyOnWriteArrayList<Listener> listeners = new CopyOnWriteArrayList<>();
  private boolean runUp;

  /**
   * An outlet.
   *
   * @param name lower case words joined by hyphens, unique within the filter
   * @param type class of the results
   */
  public Outlet(String name, Class<T> type) {
    this.name = Objects.requireNonNull(name, "name");
    this.type = Objects.requireNonNull(type, "type");
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
   * Whether anyone listens; a filter may skip making results that nobody takes.
   *
   * @return true with at least one subscriber
   */
  public boolean hasSubscribers() {
    return !listeners.isEmpty();
  }

  /**
   * Listens to results, but not during a run-up, whose events come once more.
   *
   * @param subscriber called on the processing thread for each result
   * @return ends the subscription when closed
   */
  public Subscription subscribe(Consumer<? super T> subscriber) {
    return listen(subscriber, false);
  }

  /**
   * Listens to results, during a run-up too, as one does who shows the newest result alone.
   *
   * @param subscriber called on the processing thread for each result
   * @return ends the subscription when closed
   */
  public Subscription follow(Consumer<? super T> subscriber) {
    return listen(subscriber, true);
  }

  private Subscription listen(Consumer<? super T> subscriber, boolean inRunUps) {
    Listener listener = new Listener(Objects.requireNonNull(subscriber, "subscriber"), inRunUps);
    listeners.add(listener);
    return listener;
  }

  void setRunUp(boolean on) {
    runUp = on;
  }

  /**
   * Hands a result to all subscribers, during a run-up to those who {@link #follow} it.
   *
   * @param result immutable
   */
  public void publish(T result) {
    for (Listener listener : listeners) {
      if (listener.inRunUps || !runUp) {
        listener.subscriber.accept(result);
      }
    }
  }

  /** One subscription; the same subscriber may have several. */
  private final class Listener implements Subscription {
    final Consumer<? super T> subscriber;
    final boolean inRunUps;

    Listener(Consumer<? super T> subscriber, boolean inRunUps) {
      this.subscriber = subscriber;
      this.inRunUps = inRunUps;
    }

    @Override
    public void close() {
      listeners.remove(this);
    }
  }
}
