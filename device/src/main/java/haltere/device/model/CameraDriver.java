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

  /** Where its data come from. */
  DataEndpoint endpoint();

  /** A decoder for a new stream. */
  WireDecoder newDecoder(boolean samples);

  /** Takes the way to the camera and sends it all settings. */
  void connect(UsbTransport transport) throws CameraProblem;

  /**
   * Has the camera send events.
   *
   * @param startTransfers to be run when the endpoint is ready
   */
  void start(Runnable startTransfers) throws CameraProblem;

  /** Has the camera send nothing any more. */
  void stop() throws CameraProblem;

  /** Gives up the way to the camera. */
  void disconnect();

  /** Its abilities, by their interfaces of {@code haltere.core.camera}. */
  Map<Class<?>, Object> facets();
}
