package haltere.testing.usb;

import java.util.Locale;

/**
 * A control request as the device sees it.
 *
 * @param type bmRequestType
 * @param request bRequest
 * @param value wValue
 * @param index wIndex
 * @param length wLength
 * @param data what came with it
 */
public record ControlRequest(int type, int request, int value, int index, int length, byte[] data) {
  /** bmRequestType of a vendor request to the device. */
  public static final int TO_DEVICE = 0x40;

  /** bmRequestType of a vendor request to the host. */
  public static final int TO_HOST = 0xc0;

  @Override
  public String toString() {
    return String.format(
        Locale.ROOT, "%02x:%02x v=%04x i=%04x n=%d", type, request, value, index, length);
  }
}
