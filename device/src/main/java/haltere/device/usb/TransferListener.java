package haltere.device.usb;

/**
 * Told of the end of a transfer, on a thread that works for the bus and must not be kept waiting.
 */
@FunctionalInterface
public interface TransferListener {
  /**
   * A transfer has ended and is not under way any more.
   *
   * @param end how
   * @param bytes how many came, also if it ended badly
   */
  void ended(TransferEnd end, int bytes);
}
