package haltere.device.model;

import haltere.core.camera.CameraInfo;
import haltere.core.camera.CameraProblem;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.device.usb.UsbDevice;
import haltere.device.usb.UsbTransport;
import java.util.function.LongConsumer;

/**
 * DAVIS240 and DAVIS346 of iniVation, on USB 2 and USB 3 boards; the model is read from the chip.
 */
final class DavisModel implements CameraModel {
  private static final int VENDOR = 0x152a;
  private static final int USB3 = 0x841a;
  private static final int USB2 = 0x841b;

  private final LongConsumer pause;

  DavisModel(LongConsumer pause) {
    this.pause = pause;
  }

  @Override
  public String key() {
    return "davis";
  }

  @Override
  public String name() {
    return "DAVIS";
  }

  @Override
  public boolean matches(UsbDevice device) {
    return device.vendorId() == VENDOR
        && (device.productId() == USB3 || device.productId() == USB2);
  }

  @Override
  public SensorGeometry nominalGeometry() {
    return new SensorGeometry(346, 260, Origin.TOP);
  }

  @Override
  public String remark() {
    return "";
  }

  @Override
  public CameraDriver driver(UsbTransport transport, String id, String serial)
      throws CameraProblem {
    DavisIdentity identity = DavisIdentity.of(transport);
    return new DavisDriver(
        new CameraInfo(id, identity.name(), serial, identity.layout().geometry(), true, ""),
        identity,
        pause);
  }
}
