package haltere.device.usb;

/** Receives the end of a transfer, on an event-handling thread of the bus; must return at once. */
@FunctionalInterface
public interface TransferListener {
  /**
   * Called when a transfer has ended.
   *
   * @param end its result
   * @param bytes received bytes, also after a failure
   */
  void ended(TransferEnd end, int bytes);
}
