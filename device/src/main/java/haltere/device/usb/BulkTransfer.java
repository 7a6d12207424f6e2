package haltere.device.usb;

import java.nio.ByteBuffer;

/**
 * A reusable transfer from a device; only {@link TransferRing} uses it.
 *
 * <p>Thread rule: under the lock of its ring.
 */
public interface BulkTransfer {
  /**
   * Starts it.
   *
   * @param buffer direct, filled from 0 to its capacity; not touched until the listener is called
   * @return true if it is active; false if the device rejects it, mostly because it is unplugged
   */
  boolean submit(ByteBuffer buffer);

  /** Requests its cancellation; the listener will be called. No effect if it is not active. */
  void cancel();
}
