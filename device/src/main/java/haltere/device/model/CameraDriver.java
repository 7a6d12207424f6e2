package haltere.device.model;

import haltere.core.camera.CameraInfo;
import haltere.core.camera.CameraProblem;
import haltere.device.protocol.WireDecoder;
import haltere.device.usb.UsbTransport;
import java.util.Map;

/**
 * Commands of one camera. Stores its settings, to restore them after it was unplugged.
 *
 * <p>Thread rule: {@link #connect} to {@link #disconnect} are called by one thread at a time;
 * facets by any thread.
 */
interface CameraDriver {
  /** The camera. */
  CameraInfo info();

  /** Endpoint of its data. */
  DataEndpoint endpoint();

  /** A decoder for a new stream. */
  WireDecoder newDecoder(boolean samples);

  /** Connects to the camera and sends all settings. */
  void connect(UsbTransport transport) throws CameraProblem;

  /**
   * Starts the events of the camera.
   *
   * @param startTransfers run when the endpoint is ready
   */
  void start(Runnable startTransfers) throws CameraProblem;

  /** Stops the events of the camera. */
  void stop() throws CameraProblem;

  /** Disconnects from the camera. */
  void disconnect();

  /** Its facets, by their interfaces of {@code haltere.core.camera}. */
  Map<Class<?>, Object> facets();
}
