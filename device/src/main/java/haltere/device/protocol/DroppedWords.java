package haltere.device.protocol;

import java.nio.ByteBuffer;
import java.util.function.Consumer;

/**
 * Summary of bytes that were dropped before decoding: the number of events, and a few words that
 * restore the decoder's state after them, above all its time. Its size is constant.
 *
 * <p>Thread rule: one thread at a time.
 */
public abstract class DroppedWords {
  private long transfers;
  private long bytes;
  private boolean broken;

  /** An empty summary. */
  DroppedWords() {}

  /**
   * Adds bytes dropped after the previous ones.
   *
   * @param dropped the bytes of one transfer; its position does not move
   */
  public final void add(ByteBuffer dropped) {
    transfers++;
    bytes += dropped.remaining();
    scan(dropped);
  }

  /**
   * Adds later dropped bytes.
   *
   * @param later of the same camera; it does not change
   */
  public final void add(DroppedWords later) {
    if (later.isEmpty()) {
      return;
    }
    transfers += later.transfers;
    bytes += later.bytes;
    broken |= later.broken;
    join(later);
  }

  /** Adds a loss of unknown size. */
  public final void addUnknown() {
    broken = true;
  }

  /** Clears the summary. */
  public final void clear() {
    transfers = 0;
    bytes = 0;
    broken = false;
    forget();
  }

  /**
   * Whether nothing was dropped.
   *
   * @return true if nothing was added
   */
  public final boolean isEmpty() {
    return transfers == 0 && !broken;
  }

  /**
   * Whether there are losses of unknown size.
   *
   * @return true after {@link #addUnknown}
   */
  public final boolean isUnknown() {
    return broken;
  }

  /**
   * Transfers that were dropped.
   *
   * @return a count
   */
  public final long transfers() {
    return transfers;
  }

  /**
   * Bytes that were dropped.
   *
   * @return a count
   */
  public final long bytes() {
    return bytes;
  }

  /**
   * Events in them.
   *
   * @return an exact count
   */
  public abstract long events();

  /**
   * Provides words with the same effect on the decoder's state, without events.
   *
   * @param decoder receives them, piece by piece
   */
  public abstract void replay(Consumer<ByteBuffer> decoder);

  abstract void scan(ByteBuffer dropped);

  abstract void join(DroppedWords later);

  abstract void forget();
}
