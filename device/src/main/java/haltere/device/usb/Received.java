package haltere.device.usb;

import haltere.device.protocol.DroppedWords;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Data of one transfer, and the words dropped before it. The objects of a {@link ReceivedBuffers}
 * are reused; none is created while a camera runs.
 *
 * <p>Thread rule: belongs to the ring while it is filled, to the consumer between {@link
 * ReceivedBuffers#take} and {@link ReceivedBuffers#release}, else to the lock of its buffers.
 */
public final class Received {
  private final ByteBuffer buffer;
  private int length;
  private TransferEnd end = TransferEnd.COMPLETED;
  private long arrivedNanos;
  private DroppedWords before;

  Received(ByteBuffer buffer, DroppedWords before) {
    this.buffer = buffer;
    this.before = before;
  }

  /** The whole buffer, for the device to fill. */
  ByteBuffer buffer() {
    return buffer;
  }

  void filled(TransferEnd how, int bytes, long nanos) {
    end = how;
    length = bytes;
    arrivedNanos = nanos;
  }

  /** Replaces the summary of earlier dropped words. */
  DroppedWords swapBefore(DroppedWords other) {
    DroppedWords old = before;
    before = other;
    return old;
  }

  /**
   * The received bytes.
   *
   * @return a new view, little-endian
   */
  public ByteBuffer bytes() {
    return buffer.slice(0, length).order(ByteOrder.LITTLE_ENDIAN);
  }

  /**
   * How the transfer ended.
   *
   * @return if not completed, data are missing after the bytes
   */
  public TransferEnd end() {
    return end;
  }

  /**
   * Time of arrival.
   *
   * @return by {@link System#nanoTime}
   */
  public long arrivedNanos() {
    return arrivedNanos;
  }

  /**
   * The words dropped before it.
   *
   * @return may be empty
   */
  public DroppedWords before() {
    return before;
  }

  int length() {
    return length;
  }
}
