package haltere.device.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.camera.CameraInfo;
import haltere.core.camera.CameraOptions;
import haltere.core.camera.CameraProblem;
import haltere.core.camera.CameraProblem.Kind;
import haltere.device.usb.UsbBus;
import haltere.device.usb.UsbDevice;
import haltere.device.usb.UsbTransport;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** Cameras without a driver, and the reasons listed for them. */
class KnownCameraTest {
  /** A bus with devices that nobody may touch. */
  private static UsbBus busWith(UsbDevice... devices) {
    return new UsbBus() {
      @Override
      public List<UsbDevice> devices() {
        return List.of(devices);
      }

      @Override
      public UsbTransport open(UsbDevice device) {
        throw new AssertionError("it was opened");
      }
    };
  }

  @Test
  void unsupportedCameraIsListedWithTheReasonAndNeverOpened() {
    UsbCameraProvider provider =
        new UsbCameraProvider(
            busWith(
                new UsbDevice(0x152a, 0x8419, 0, 1, 5),
                new UsbDevice(0x1409, 0x8e00, 0, 1, 6),
                new UsbDevice(0x04b4, 0x8613, 0, 1, 7),
                new UsbDevice(0x1234, 0x5678, 0, 1, 8)));

    List<CameraInfo> seen = provider.list();

    assertEquals(
        List.of("dvxplorer:1-5", "fx2:1-7", "ids:1-6"), seen.stream().map(CameraInfo::id).toList());
    assertTrue(seen.stream().noneMatch(CameraInfo::canOpen));
    assertTrue(seen.get(0).note().contains("record with its maker's program"));
    CameraProblem problem =
        assertThrows(
            CameraProblem.class, () -> provider.open(seen.get(0), CameraOptions.DEFAULT).close());
    assertEquals(Kind.UNSUPPORTED, problem.kind());
    assertEquals(seen.get(0).note(), problem.getMessage());
  }

  @Test
  void usbIdsOfKnownCamerasAreUnique() {
    for (CameraModel one : KnownCamera.ALL) {
      KnownCamera known = (KnownCamera) one;
      UsbDevice device = new UsbDevice(known.usbId() >>> 16, known.usbId() & 0xffff, 0, 1, 2);
      assertEquals(1, KnownCamera.ALL.stream().filter(other -> other.matches(device)).count());
      assertFalse(new EvkModel().matches(device) || new Dvs128Model().matches(device));
    }
  }

  @Test
  void unavailableUsbIsReportedWithTheReason() {
    UsbBus none =
        new UsbBus() {
          @Override
          public List<UsbDevice> devices() throws CameraProblem {
            throw new CameraProblem(Kind.UNSUPPORTED, "libusb was not found");
          }

          @Override
          public UsbTransport open(UsbDevice device) {
            throw new AssertionError("there is none");
          }
        };
    UsbCameraProvider provider = new UsbCameraProvider(none);

    assertEquals(List.of(), provider.list());
    assertEquals(Optional.of("libusb was not found"), provider.obstacle());
    assertEquals(Optional.empty(), new UsbCameraProvider(busWith()).obstacle());
  }
}
