package haltere.device.model;

import haltere.core.camera.CameraProblem;
import haltere.core.camera.CameraProblem.Kind;
import haltere.device.usb.UsbTransport;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Locale;

/**
 * Commands of Prophesee's boards: property, length and data; the answer repeats the property.
 *
 * <p>Source: the public driver of Prophesee's boards (OpenEB), facts only.
 */
final class TreuzellLine {
  private static final int COMMANDS = 0x02;
  private static final int ANSWERS = 0x82;
  private static final int HEAD_BYTES = 8;
  private static final int MAX_ANSWER_BYTES = 1024;
  private static final int WRITE = 1 << 30;
  private static final int FAILED = 1 << 31;
  private static final int SERIAL = 0x72;
  private static final int COMPATIBLE = 0x10003;
  private static final int STREAM = 0x10200;
  private static final int SENSOR = 0;

  private final UsbTransport transport;

  TreuzellLine(UsbTransport transport) {
    this.transport = transport;
  }

  String serial() throws CameraProblem {
    ByteBuffer answer = command(SERIAL);
    if (answer.remaining() < Integer.BYTES) {
      throw new CameraProblem(Kind.BROKEN, "the camera does not report its serial number");
    }
    return String.format(Locale.ROOT, "%08x", answer.getInt());
  }

  /** Compatibility string of the sensor, such as {@code psee,ccam5_imx636}. */
  String sensor() throws CameraProblem {
    ByteBuffer answer = command(COMPATIBLE, SENSOR);
    byte[] text = new byte[Math.max(0, answer.remaining() - Integer.BYTES)];
    answer.position(answer.limit() - text.length).get(text);
    return new String(text, StandardCharsets.ISO_8859_1).replace('\0', ' ').trim();
  }

  void stream(boolean on) throws CameraProblem {
    command(STREAM | WRITE, SENSOR, on ? 1 : 0);
  }

  private ByteBuffer command(int property, int... payload) throws CameraProblem {
    ByteBuffer command =
        ByteBuffer.allocate(HEAD_BYTES + payload.length * Integer.BYTES)
            .order(ByteOrder.LITTLE_ENDIAN);
    command.putInt(property).putInt(payload.length * Integer.BYTES);
    for (int word : payload) {
      command.putInt(word);
    }
    transport.write(COMMANDS, command.array());
    ByteBuffer answer =
        ByteBuffer.wrap(transport.read(ANSWERS, MAX_ANSWER_BYTES)).order(ByteOrder.LITTLE_ENDIAN);
    if (answer.remaining() < HEAD_BYTES) {
      throw new CameraProblem(
          Kind.BROKEN, String.format("incomplete answer to command 0x%x", property));
    }
    int echo = answer.getInt();
    int length = answer.getInt();
    if ((echo & FAILED) != 0) {
      throw new CameraProblem(
          Kind.REFUSED, String.format("the camera refused command 0x%x", property));
    }
    if ((echo & ~WRITE) != (property & ~WRITE) || length < 0 || length > answer.remaining()) {
      throw new CameraProblem(
          Kind.BROKEN, String.format("a wrong answer to command 0x%x: 0x%x", property, echo));
    }
    return answer.limit(answer.position() + length);
  }
}
