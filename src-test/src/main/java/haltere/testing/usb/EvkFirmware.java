package haltere.testing.usb;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/**
 * A Prophesee EVK4 as far as publicly documented: commands over bulk, and a stream that is on or
 * off.
 *
 * <p>Thread rule: all methods may be called from any thread.
 */
public final class EvkFirmware implements Firmware {
  /** The endpoint of events. */
  public static final int ENDPOINT = 0x81;

  private static final int ANSWERS = 0x82;
  private static final int STREAM = 0x4001_0200;
  private static final int FAILED = 1 << 31;
  private volatile EmulatedDevice device;
  private volatile boolean streaming;
  private volatile boolean refusingStream;
  private volatile boolean busy;
  private volatile String sensor = "psee,ccam5_imx636";

  @Override
  public byte[] deviceDescriptor() {
    return Descriptors.bytes("12 01 00 02 00 00 00 40 b4 04 f5 00 00 01 01 02 00 01");
  }

  @Override
  public byte[] configurationDescriptor() {
    return Descriptors.bytes(
        "09 02 27 00 01 01 00 80 64"
            + "09 04 00 00 03 ff 19 00 00"
            + "07 05 81 02 00 02 00"
            + "07 05 82 02 00 02 00"
            + "07 05 02 02 00 02 00");
  }

  @Override
  public String string(int index) {
    return null;
  }

  @Override
  public int systemCall(int call) {
    return busy && call == UsbEmulator.CLAIM ? EmulatedDevice.EBUSY : 0;
  }

  @Override
  public byte[] control(ControlRequest request) {
    return null;
  }

  @Override
  public void attached(EmulatedDevice newDevice) {
    device = newDevice;
  }

  /**
   * Whether it is streaming.
   *
   * @return true between the commands to start and stop
   */
  public boolean isStreaming() {
    return streaming;
  }

  /**
   * Denies claims, as while a program has the device.
   *
   * @param nowBusy whether it does
   */
  public void setBusy(boolean nowBusy) {
    busy = nowBusy;
  }

  /**
   * Has another sensor on the board.
   *
   * @param compatible what it says that it is compatible with
   */
  public void setSensor(String compatible) {
    sensor = compatible;
  }

  /**
   * Refuses the command that starts and stops the stream.
   *
   * @param refuse whether it does
   */
  public void refuseStream(boolean refuse) {
    refusingStream = refuse;
  }

  @Override
  public void written(int endpoint, byte[] data) {
    ByteBuffer command = ByteBuffer.wrap(data).order(ByteOrder.LITTLE_ENDIAN);
    int property = command.getInt();
    command.getInt();
    if (refusingStream && property == STREAM) {
      answer(property | FAILED, ByteBuffer.allocate(0));
      return;
    }
    switch (property) {
      case 0x72 -> answer(property, ByteBuffer.allocate(4).put(new byte[] {0x21, 0x43, 0, 0}));
      case 0x10003 -> {
        byte[] text = (sensor + "\0").getBytes(StandardCharsets.ISO_8859_1);
        answer(property, ByteBuffer.allocate(4 + text.length).putInt(0).put(text));
      }
      case STREAM -> {
        command.getInt();
        streaming = command.getInt() == 1;
        answer(property, ByteBuffer.allocate(0));
      }
      default -> answer(property | FAILED, ByteBuffer.allocate(0));
    }
  }

  private void answer(int property, ByteBuffer payload) {
    ByteBuffer answer = ByteBuffer.allocate(8 + payload.capacity()).order(ByteOrder.LITTLE_ENDIAN);
    answer.putInt(property).putInt(payload.capacity()).put(payload.array());
    device.send(ANSWERS, answer.array());
  }
}
