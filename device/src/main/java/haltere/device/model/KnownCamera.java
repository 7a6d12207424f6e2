package haltere.device.model;

import haltere.core.camera.CameraProblem;
import haltere.core.camera.CameraProblem.Kind;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.device.usb.UsbDevice;
import haltere.device.usb.UsbTransport;
import java.util.List;

/**
 * An event camera that is recognised but not supported: it is listed, with an alternative.
 *
 * @param key prefix of its ids
 * @param name for users
 * @param usbId vendor in the upper 16 bits, product in the lower
 * @param nominalGeometry its sensor, or the largest of its models
 * @param obstacle why it is not supported, and advice
 */
record KnownCamera(
    String key, String name, int usbId, SensorGeometry nominalGeometry, String obstacle)
    implements CameraModel {
  private static final SensorGeometry IMX636 = new SensorGeometry(1280, 720, Origin.TOP);

  private static final String OTHER_BOARD =
      "of Prophesee's cameras only the EVK4 is supported, as an experiment; record "
          + "with the maker's program as RAW, which can be read";

  private static final String NO_FIRMWARE =
      "a chip without firmware, perhaps of a camera; write the firmware with its "
          + "maker's program first";

  /** Cameras and boards with public USB ids. */
  static final List<CameraModel> ALL =
      List.of(
          new KnownCamera(
              "dvxplorer",
              "DVXplorer",
              0x152a_8419,
              new SensorGeometry(640, 480, Origin.TOP),
              "its protocol is not supported; record with its maker's program (DV) as "
                  + "AEDAT-4, which can be read"),
          new KnownCamera("centuryarks", "CenturyArks", 0x31f7_0003, IMX636, OTHER_BOARD),
          new KnownCamera("ids", "IDS event camera", 0x1409_8e00, IMX636, OTHER_BOARD),
          new KnownCamera("prophesee", "Prophesee board", 0x03fd_5832, IMX636, OTHER_BOARD),
          new KnownCamera("prophesee", "Prophesee board", 0x1fc9_5838, IMX636, OTHER_BOARD),
          new KnownCamera(
              "fx2",
              "FX2 without firmware",
              0x04b4_8613,
              new SensorGeometry(128, 128),
              NO_FIRMWARE),
          new KnownCamera(
              "fx3",
              "FX3 without firmware",
              0x04b4_00f3,
              new SensorGeometry(346, 260, Origin.TOP),
              NO_FIRMWARE));

  @Override
  public boolean matches(UsbDevice device) {
    return usbId == (device.vendorId() << 16 | device.productId());
  }

  @Override
  public String remark() {
    return "";
  }

  @Override
  public CameraDriver driver(UsbTransport transport, String id, String serial)
      throws CameraProblem {
    throw new CameraProblem(Kind.UNSUPPORTED, obstacle);
  }
}
