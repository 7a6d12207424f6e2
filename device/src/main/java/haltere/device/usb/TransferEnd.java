package haltere.device.usb;

/** End status of a transfer. */
public enum TransferEnd {
  /** The buffer is full, or the device has no more data for now. */
  COMPLETED,
  /** Cancelled by this program. Some systems report this for an unplugged device. */
  CANCELLED,
  /** The endpoint is halted. */
  STALLED,
  /** The device sent more than the buffer takes. */
  OVERFLOW,
  /** Another error of the bus. Some systems report this for an unplugged device. */
  FAILED,
  /** The device was unplugged. */
  GONE
}
