package haltere.ui.rendering;

import java.util.concurrent.atomic.AtomicLong;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Supplier;

/**
 * Passes preallocated pictures from the painting thread to the displaying thread, without locks or
 * allocation: one is painted, one is finished, one is shown. A finished picture that nobody has
 * fetched is conflated with the next one, and counted.
 *
 * @param <T> type of the pictures
 */
public final class FrameExchange<T> {
  private record Slot<T>(T value, boolean fresh) {}

  private final AtomicReference<Slot<T>> finished;
  private final AtomicLong conflated = new AtomicLong();
  private T painted;
  private T shown;

  /** An exchange without a finished picture; creates three. */
  public FrameExchange(Supplier<? extends T> factory) {
    painted = factory.get();
    finished = new AtomicReference<>(new Slot<>(factory.get(), false));
    shown = factory.get();
  }

  /** The picture to paint into, the painter's until {@link #publish}. Painting thread only. */
  public T back() {
    return painted;
  }

  /** Hands the painted picture over. Painting thread only. */
  public void publish() {
    Slot<T> previous = finished.getAndSet(new Slot<>(painted, true));
    if (previous.fresh()) {
      conflated.incrementAndGet();
    }
    painted = previous.value();
  }

  /**
   * Whether the newest picture has not been fetched, so that another one would replace it. Any
   * thread.
   */
  public boolean isPending() {
    return finished.get().fresh();
  }

  /**
   * The newest picture, owned by the displaying thread until it fetches the next one; null without
   * a new one. Displaying thread only.
   */
  public T fetch() {
    if (!finished.get().fresh()) {
      return null;
    }
    shown = finished.getAndSet(new Slot<>(shown, false)).value();
    return shown;
  }

  /** How many pictures were replaced before they were fetched. Any thread. */
  public long conflated() {
    return conflated.get();
  }
}
