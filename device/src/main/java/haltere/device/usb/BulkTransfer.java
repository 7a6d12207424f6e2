package haltere.device.usb;

import java.nio.ByteBuffer;

/**
 * A transfer from a device, used again and again; only {@link TransferRing} uses it.
 *
 * <p>Thread rule: under the lock of its ring.
 */
public interface BulkTransfer {
  /**
   * Starts it.
   *
   * @param buffer direct, filled from 0 to its capacity; not touched until the listener is called
   * @return true if it is under way; false if the device does not take it, mostly because it is
   *     gone
   */
  boolean submit(ByteBuffer buffer);

  /** Asks for its end; the listener will be called. Does nothing if it is not under way. */
  void cancel();
}
