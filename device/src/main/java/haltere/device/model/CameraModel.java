package haltere.device.model;

import haltere.core.camera.CameraProblem;
import haltere.core.event.SensorGeometry;
import haltere.device.usb.UsbDevice;
import haltere.device.usb.UsbTransport;

/**
 * A camera model.
 *
 * <p>Thread rule: immutable.
 */
interface CameraModel {
  /** Prefix of its ids, such as {@code dvs128}. */
  String key();

  /** Name for users. */
  String name();

  /** Whether a device is of this model. */
  boolean matches(UsbDevice device);

  /**
   * Reads the serial number of a claimed camera without one in its descriptor.
   *
   * @param transport to ask
   * @return empty if it has none
   * @throws CameraProblem if it does not answer
   */
  default String serial(UsbTransport transport) throws CameraProblem {
    return "";
  }

  /** Its sensor, as far as known before opening. */
  SensorGeometry nominalGeometry();

  /** Why it is not supported, and advice; or empty. */
  default String obstacle() {
    return "";
  }

  /** A remark for the list of cameras, or empty. */
  String remark();

  /**
   * Creates the driver of an open and claimed camera.
   *
   * @param transport to identify the camera; not stored
   * @param id of the camera
   * @param serial of the camera
   * @return a driver that is not connected yet
   * @throws CameraProblem if this camera is not supported
   */
  CameraDriver driver(UsbTransport transport, String id, String serial) throws CameraProblem;
}
