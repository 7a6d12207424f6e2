package haltere.testing.usb;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.HexFormat;

/** USB descriptors as bytes. */
final class Descriptors {
  private static final int STRING = 3;
  private static final byte[] ENGLISH = {4, STRING, 9, 4};

  private Descriptors() {}

  /** Bytes from a text of them, in which blanks mean nothing. */
  static byte[] bytes(String hex) {
    return HexFormat.of().parseHex(hex.replaceAll("\\s", ""));
  }

  /** The descriptor of a string, or null if there is none. */
  static byte[] string(Firmware firmware, int index) {
    if (index == 0) {
      return ENGLISH.clone();
    }
    String text = firmware.string(index);
    if (text == null) {
      return null;
    }
    byte[] letters = text.getBytes(StandardCharsets.UTF_16LE);
    ByteArrayOutputStream descriptor = new ByteArrayOutputStream();
    descriptor.write(letters.length + 2);
    descriptor.write(STRING);
    descriptor.writeBytes(letters);
    return descriptor.toByteArray();
  }
}
