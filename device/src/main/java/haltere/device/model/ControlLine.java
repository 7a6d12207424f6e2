package haltere.device.model;

import haltere.core.camera.CameraProblem;
import haltere.device.usb.UsbTransport;

/**
 * The transport for a camera's settings, while it is plugged in.
 *
 * <p>Thread rule: all methods may be called from any thread.
 */
final class ControlLine {
  private volatile UsbTransport transport;

  void connect(UsbTransport newTransport) {
    transport = newTransport;
  }

  void disconnect() {
    transport = null;
  }

  boolean isConnected() {
    return transport != null;
  }

  UsbTransport transport() throws CameraProblem {
    UsbTransport now = transport;
    if (now == null) {
      throw new CameraProblem(CameraProblem.Kind.GONE, "the camera is not plugged in");
    }
    return now;
  }

  void send(int request, int value, int index, byte... data) throws CameraProblem {
    transport().send(request, value, index, data);
  }

  byte[] query(int request, int value, int index, int length) throws CameraProblem {
    return transport().query(request, value, index, length);
  }
}
