package haltere.device.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.camera.Camera;
import haltere.core.camera.CameraInfo;
import haltere.core.camera.CameraOptions;
import haltere.core.camera.CameraProblem;
import haltere.core.event.Trigger;
import haltere.testing.usb.EvkFirmware;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.junit.jupiter.api.Test;

/** Scenarios of an EVK4 on any bus, as far as its protocol is known. */
abstract class EvkScenarios extends DeviceBench<EvkFirmware> {
  EvkScenarios(BusUnderTest on) {
    super(on);
  }

  @Override
  EvkFirmware newFirmware() {
    return new EvkFirmware();
  }

  private static byte[] words(int... words) {
    ByteBuffer bytes = ByteBuffer.allocate(2 * words.length).order(ByteOrder.LITTLE_ENDIAN);
    for (int word : words) {
      bytes.putShort((short) word);
    }
    return bytes.array();
  }

  @Test
  void evk4IsListedAsExperimental() {
    CameraInfo info = provider.list().get(0);

    assertEquals("evk4:00004321", info.id());
    assertTrue(info.canOpen());
    assertTrue(info.note().startsWith("experimental"));
  }

  @Test
  void evk4ReportsItsSerialNumberStreamsAndStops() throws IOException {
    Camera camera = open(CameraOptions.DEFAULT.withSamples(true));
    StreamLog log = started(camera);
    assertEquals("00004321", camera.info().serial());
    assertTrue(firmware.isStreaming());

    device.send(
        EvkFirmware.ENDPOINT, words(0x8001, 0x6005, 0x0000 | 10, 0x2800 | 20, 0xa301, 0x6007));
    device.send(EvkFirmware.ENDPOINT, words(0x3800 | 100, 0x4003, 0x5001));
    log.untilEvents(4);

    assertEquals(4096 + 5, log.all.timeUs(0));
    assertEquals(709, log.all.y(0));
    assertEquals(112, log.all.x(3));
    assertEquals(
        new Trigger(4096 + 5, Trigger.Source.EXTERNAL_INPUT, Trigger.Edge.RISING, 3),
        log.items.get(1));
    camera.close();
    assertFalse(firmware.isStreaming());
  }

  @Test
  void evk4InUseIsListedByTheIdThatItWasOpenedWith() throws IOException {
    try (Camera camera = open(CameraOptions.DEFAULT)) {
      firmware.setBusy(true);
      CameraInfo listed = provider.list().get(0);

      assertEquals(camera.info().id(), listed.id());
      assertEquals("00004321", listed.serial());
      assertFalse(listed.canOpen());
    }
  }

  @Test
  void unsupportedSensorIsRejectedWithItsName() {
    firmware.setSensor("psee,ccam5_gen41");

    CameraProblem problem =
        assertThrows(CameraProblem.class, () -> open(CameraOptions.DEFAULT).close());

    assertEquals(CameraProblem.Kind.UNSUPPORTED, problem.kind());
    assertTrue(problem.getMessage().contains("psee,ccam5_gen41"), problem.getMessage());
  }

  @Test
  void refusedCommandIsReportedWithItsRegister() throws IOException {
    try (Camera camera = open(CameraOptions.DEFAULT)) {
      firmware.refuseStream(true);

      CameraProblem problem = assertThrows(CameraProblem.class, () -> started(camera));

      assertEquals(CameraProblem.Kind.REFUSED, problem.kind());
      assertTrue(problem.getMessage().contains("0x40010200"), problem.getMessage());
    }
  }

  @Test
  void reconnectedEvk4IsRecognizedByItsSerialNumberAndContinues() throws IOException {
    try (Camera camera = open(CameraOptions.DEFAULT.withReconnect(true))) {
      StreamLog log = started(camera);
      device.send(EvkFirmware.ENDPOINT, words(0x8001, 0x6005, 10, 0x2800 | 20));
      log.untilEvents(1);
      device.unplug();
      log.until(() -> log.ends() == 1);

      EvkFirmware again = newFirmware();
      plug(again);
      log.until(() -> camera.statistics().streams() == 2);
      device.send(EvkFirmware.ENDPOINT, words(0x8000, 0x6003, 10, 0x2800 | 20));
      log.untilEvents(2);

      assertTrue(again.isStreaming());
      assertEquals(3, log.all.timeUs(1));
    }
  }
}
