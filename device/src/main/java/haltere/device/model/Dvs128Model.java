package haltere.device.model;

import haltere.core.camera.CameraInfo;
import haltere.core.event.SensorGeometry;
import haltere.device.usb.UsbDevice;
import haltere.device.usb.UsbTransport;

/** The DVS128 of iniLabs, with its USB 2 board. */
final class Dvs128Model implements CameraModel {
  private static final SensorGeometry GEOMETRY = new SensorGeometry(128, 128);

  @Override
  public String key() {
    return "dvs128";
  }

  @Override
  public String name() {
    return "DVS128";
  }

  @Override
  public boolean matches(UsbDevice device) {
    return device.vendorId() == 0x152a && device.productId() == 0x8400
        || device.vendorId() == 0x0547 && device.productId() == 0x8700;
  }

  @Override
  public SensorGeometry nominalGeometry() {
    return GEOMETRY;
  }

  @Override
  public String remark() {
    return "";
  }

  @Override
  public CameraDriver driver(UsbTransport transport, String id, String serial) {
    return new Dvs128Driver(
        new CameraInfo(id, name(), serial, GEOMETRY, true, ""),
        transport.device().version() & 0xff);
  }
}
