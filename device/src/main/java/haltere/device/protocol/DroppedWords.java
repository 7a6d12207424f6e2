package haltere.device.protocol;

import java.nio.ByteBuffer;
import java.util.function.Consumer;

/**
 * Summary of bytes that were dropped before decoding: the number of events, and a few words that
 * set the decoder to its state after them, above all to the right time. Its size is constant.
 *
 * <p>Thread rule: one thread at a time.
 */
public abstract class DroppedWords {
  private long transfers;
  private long bytes;
  private boolean broken;

  /** Nothing dropped. */
  DroppedWords() {}

  /**
   * Notes bytes that are dropped after those before.
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

  /** Notes that something else is missing of which nothing is known. */
  public final void addUnknown() {
    broken = true;
  }

  /** Forgets everything. */
  public final void clear() {
    transfers = 0;
    bytes = 0;
    broken = false;
    forget();
  }

  /**
   * Whether nothing is missing.
   *
   * @return true if nothing was noted
   */
  public final boolean isEmpty() {
    return transfers == 0 && !broken;
  }

  /**
   * Whether more is missing than was counted.
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
   * Gives the words that have the same effect on the decoder's state, without events.
   *
   * @param decoder receives them, piece by piece
   */
  public abstract void replay(Consumer<ByteBuffer> decoder);

  abstract void scan(ByteBuffer dropped);

  abstract void join(DroppedWords later);

  abstract void forget();
}
