package haltere.device.model;

import haltere.core.camera.CameraProblem;
import haltere.device.usb.UsbTransport;
import java.nio.ByteBuffer;

/**
 * The registers of a DAVIS camera's logic: 32 bits for each module and parameter.
 *
 * <p>Thread rule: all methods may be called from any thread.
 */
final class DavisRegisters {
  static final int MULTIPLEXER = 0;
  static final int EVENTS = 1;
  static final int FRAMES = 2;
  static final int INERTIAL = 3;
  static final int INPUT = 4;
  static final int BIASES = 5;
  static final int SYSTEM = 6;
  static final int USB = 9;

  private static final int SET_OR_GET = 0xbf;
  private static final int SET_SEVERAL = 0xc2;
  private static final int RECORD_BYTES = 6;

  private final ControlLine line;

  DavisRegisters(ControlLine line) {
    this.line = line;
  }

  void set(int module, int parameter, int value) throws CameraProblem {
    line.send(SET_OR_GET, module, parameter, bytes(value));
  }

  int get(int module, int parameter) throws CameraProblem {
    return get(line.transport(), module, parameter);
  }

  static int get(UsbTransport transport, int module, int parameter) throws CameraProblem {
    return ByteBuffer.wrap(transport.query(SET_OR_GET, module, parameter, Integer.BYTES)).getInt();
  }

  /** Sets a parameter to 1 and then to 0. */
  void pulse(int module, int parameter) throws CameraProblem {
    ByteBuffer records = ByteBuffer.allocate(2 * RECORD_BYTES);
    for (int value = 1; value >= 0; value--) {
      records.put((byte) module).put((byte) parameter).putInt(value);
    }
    line.send(SET_SEVERAL, 2, 0, records.array());
  }

  private static byte[] bytes(int value) {
    return ByteBuffer.allocate(Integer.BYTES).putInt(value).array();
  }
}
