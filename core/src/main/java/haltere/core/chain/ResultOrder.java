package haltere.core.chain;

import java.util.Comparator;
import java.util.Objects;
import java.util.PriorityQueue;
import java.util.function.Consumer;
import java.util.function.ToLongFunction;

/**
 * The order of an outlet's results in a table, if they are published out of order. A filter that
 * decides late publishes results with times before those that it published already.
 *
 * @param lateUs how much older than the latest result one may be, at least 0
 * @param timeUs the time of a result
 * @param ties the order of results with the same time
 * @param <T> type of the results
 * @since 0.1
 */
public record ResultOrder<T>(
    long lateUs, ToLongFunction<? super T> timeUs, Comparator<? super T> ties) {
  /** Checks the values. */
  public ResultOrder {
    if (lateUs < 0) {
      throw new IllegalArgumentException("results are late by 0 us or more, not " + lateUs);
    }
    Objects.requireNonNull(timeUs, "timeUs");
    Objects.requireNonNull(ties, "ties");
  }

  /**
   * A sorter of results.
   *
   * @param next receives them in order
   * @return receives them as they are published
   */
  public Sorter<T> to(Consumer<? super T> next) {
    return new Sorter<>(this, next);
  }

  /**
   * Delays results until no earlier one can come. A time that goes back further starts a new order,
   * as at a restart of the clock of a recording.
   *
   * <p>Thread rule: one thread at a time.
   *
   * @param <T> type of the results
   */
  public static final class Sorter<T> implements Consumer<T> {
    private final ResultOrder<T> order;
    private final Consumer<? super T> next;
    private final PriorityQueue<T> held;
    private long lastUs = Long.MIN_VALUE;

    private Sorter(ResultOrder<T> order, Consumer<? super T> next) {
      this.order = order;
      this.next = Objects.requireNonNull(next, "next");
      Comparator<T> byTime = Comparator.comparingLong(order.timeUs);
      held = new PriorityQueue<>(byTime.thenComparing(order.ties));
    }

    @Override
    public void accept(T result) {
      long timeUs = order.timeUs.applyAsLong(result);
      boolean isAnew = lastUs != Long.MIN_VALUE && timeUs < lastUs - order.lateUs;
      if (isAnew) {
        finish();
      }
      lastUs = isAnew ? timeUs : Math.max(lastUs, timeUs);
      held.add(result);
      while (order.timeUs.applyAsLong(held.peek()) < lastUs - order.lateUs) {
        next.accept(held.remove());
      }
    }

    /** Passes on all delayed results. */
    public void finish() {
      while (!held.isEmpty()) {
        next.accept(held.remove());
      }
    }
  }
}
