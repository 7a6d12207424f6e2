package haltere.device.usb;

/** How a transfer ended. */
public enum TransferEnd {
  /** The buffer is full, or the device had no more to say for now. */
  COMPLETED,
  /** This program asked for it. Some systems say this of a device that was unplugged. */
  CANCELLED,
  /** The endpoint is halted. */
  STALLED,
  /** The device sent more than the buffer takes. */
  OVERFLOW,
  /** Anything else on the bus. Some systems say this of a device that was unplugged. */
  FAILED,
  /** The device was unplugged. */
  GONE
}
