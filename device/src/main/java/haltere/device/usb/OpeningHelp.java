package haltere.device.usb;

import java.util.Locale;

/**
 * Advice for devices that cannot be opened.
 *
 * <p>Thread rule: immutable.
 */
public final class OpeningHelp {
  private static final String RULE_FILE = "/etc/udev/rules.d/60-haltere.rules";

  private OpeningHelp() {}

  /**
   * Advice if this user may not open a device.
   *
   * @param device the device
   * @param system name of the operating system, as in the system property {@code os.name}
   * @return a sentence, on Linux with the udev rule and the command that sets it up
   */
  public static String forbidden(UsbDevice device, String system) {
    return system.toLowerCase(Locale.ROOT).contains("linux")
        ? "this user may not open it; plug it in again after: " + udevCommand(device)
        : "this user may not open it";
  }

  /**
   * The udev rule that lets the users of a computer open a device.
   *
   * @param device the device
   * @return a line of a rule file
   */
  public static String udevRule(UsbDevice device) {
    return String.format(
        Locale.ROOT,
        "SUBSYSTEM==\"usb\", ATTR{idVendor}==\"%04x\", ATTR{idProduct}==\"%04x\", MODE=\"0666\","
            + " TAG+=\"uaccess\"",
        device.vendorId(),
        device.productId());
  }

  /**
   * The command that adds and activates the rule.
   *
   * @param device the device
   * @return a line for a shell
   */
  public static String udevCommand(UsbDevice device) {
    return "echo '"
        + udevRule(device)
        + "' | sudo tee -a "
        + RULE_FILE
        + " && sudo udevadm control --reload-rules && sudo udevadm trigger";
  }

  /**
   * Advice if the system has another driver for a device, or none.
   *
   * @param system name of the operating system, as in the system property {@code os.name}
   * @return a sentence
   */
  public static String withoutDriver(String system) {
    return system.toLowerCase(Locale.ROOT).contains("windows")
        ? "it has no WinUSB driver; give it one with Zadig (zadig.akeo.ie)"
        : "the system does not let programs open it";
  }
}
