package haltere.ui.rendering;

import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;

/**
 * Hands preallocated pictures from the thread that paints to the thread that shows, without a lock
 * and without garbage: one is being painted, one is finished, one is being shown. A finished
 * picture that nobody has fetched is replaced by the next one, and counted.
 *
 * @param <T> type of the pictures
 */
public final class FrameExchange<T> {
  private record Slot<T>(T value, boolean fresh) {}

  private final AtomicReference<Slot<T>> finished;
  private final AtomicLong published = new AtomicLong();
  private final AtomicLong conflated = new AtomicLong();
  private T painted;
  private T shown;

  /**
   * An exchange without a finished picture.
   *
   * @param factory called three times
   */
  public FrameExchange(Supplier<? extends T> factory) {
    painted = factory.get();
    finished = new AtomicReference<>(new Slot<>(factory.get(), false));
    shown = factory.get();
  }

  /**
   * The picture to paint into. Painting thread only.
   *
   * @return the painter's until {@link #publish}
   */
  public T back() {
    return painted;
  }

  /** Hands the painted picture over. Painting thread only. */
  public void publish() {
    Slot<T> previous = finished.getAndSet(new Slot<>(painted, true));
    published.incrementAndGet();
    if (previous.fresh()) {
      conflated.incrementAndGet();
    }
    painted = previous.value();
  }

  /**
   * Whether the newest picture is still to be fetched. Any thread.
   *
   * @return true if painting another one now would replace it
   */
  public boolean isPending() {
    return finished.get().fresh();
  }

  /**
   * Fetches the newest picture. Showing thread only.
   *
   * @return the shower's until the next fetch that returns a picture; null if there is no new one
   */
  public T fetch() {
    if (!finished.get().fresh()) {
      return null;
    }
    shown = finished.getAndSet(new Slot<>(shown, false)).value();
    return shown;
  }

  /**
   * Pictures handed over so far. Any thread.
   *
   * @return a count
   */
  public long published() {
    return published.get();
  }

  /**
   * Pictures that were replaced before they were fetched. Any thread.
   *
   * @return a count
   */
  public long conflated() {
    return conflated.get();
  }
}
