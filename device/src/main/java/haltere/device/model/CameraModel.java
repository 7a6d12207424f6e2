package haltere.device.model;

import haltere.core.camera.CameraProblem;
import haltere.core.event.SensorGeometry;
import haltere.device.usb.UsbDevice;
import haltere.device.usb.UsbTransport;

/**
 * A kind of camera.
 *
 * <p>Thread rule: immutable.
 */
interface CameraModel {
  /** What its ids begin with, such as {@code dvs128}. */
  String key();

  /** What a person calls it. */
  String name();

  /** Whether a device is of this kind. */
  boolean matches(UsbDevice device);

  /**
   * Asks a camera that is claimed, and tells no number in its descriptor, for one.
   *
   * @param transport to ask
   * @return empty if it has none
   * @throws CameraProblem if it does not answer
   */
  default String serial(UsbTransport transport) throws CameraProblem {
    return "";
  }

  /** Its sensor, as far as it is known from the outside. */
  SensorGeometry usualGeometry();

  /** Why it cannot be driven at all and what to do instead, or empty. */
  default String obstacle() {
    return "";
  }

  /** A remark for whoever sees it listed, or empty. */
  String remark();

  /**
   * Makes the driver of a camera that is open and claimed.
   *
   * @param transport to ask the camera what it is; not kept
   * @param id of the camera
   * @param serial of the camera
   * @return a driver that is not connected yet
   * @throws CameraProblem if this one cannot be driven
   */
  CameraDriver driver(UsbTransport transport, String id, String serial) throws CameraProblem;
}
