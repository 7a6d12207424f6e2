package haltere.device.model;

import haltere.core.camera.CameraInfo;
import haltere.core.camera.CameraProblem;
import haltere.core.camera.CameraProblem.Kind;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.device.usb.UsbDevice;
import haltere.device.usb.UsbTransport;

/** Prophesee's EVK4 with its IMX636 sensor; an experiment, see {@link EvkDriver}. */
final class EvkModel implements CameraModel {
  static final SensorGeometry GEOMETRY = new SensorGeometry(1280, 720, Origin.TOP);

  private static final String REMARK =
      "experimental: it streams only after another program has configured its sensor";

  @Override
  public String key() {
    return "evk4";
  }

  @Override
  public String name() {
    return "EVK4";
  }

  @Override
  public boolean matches(UsbDevice device) {
    return device.vendorId() == 0x04b4
        && (device.productId() == 0x00f4 || device.productId() == 0x00f5);
  }

  @Override
  public String serial(UsbTransport transport) throws CameraProblem {
    return new TreuzellLine(transport).serial();
  }

  @Override
  public SensorGeometry nominalGeometry() {
    return GEOMETRY;
  }

  @Override
  public String remark() {
    return REMARK;
  }

  @Override
  public CameraDriver driver(UsbTransport transport, String id, String serial)
      throws CameraProblem {
    String compatible = new TreuzellLine(transport).sensor();
    if (!compatible.contains("imx636")) {
      throw new CameraProblem(
          Kind.UNSUPPORTED, "this camera's sensor is " + compatible + ", only imx636 is supported");
    }
    return new EvkDriver(new CameraInfo(id, name(), serial, GEOMETRY, true, REMARK));
  }
}
