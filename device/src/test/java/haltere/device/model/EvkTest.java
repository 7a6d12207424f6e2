package haltere.device.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.camera.Camera;
import haltere.core.camera.CameraInfo;
import haltere.core.camera.CameraOptions;
import haltere.core.event.Trigger;
import haltere.core.stream.StreamStarted;
import haltere.testing.usb.EmulatedDevice;
import haltere.testing.usb.EvkFirmware;
import haltere.testing.usb.MemoryBus;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.junit.jupiter.api.Test;

class EvkTest {
  private final MemoryBus bus = new MemoryBus();
  private final EvkFirmware firmware = new EvkFirmware();
  private final EmulatedDevice device = bus.plug(3, firmware);
  private final UsbCameraProvider provider = new UsbCameraProvider(bus);

  private static byte[] words(int... words) {
    ByteBuffer bytes = ByteBuffer.allocate(2 * words.length).order(ByteOrder.LITTLE_ENDIAN);
    for (int word : words) {
      bytes.putShort((short) word);
    }
    return bytes.array();
  }

  @Test
  void itIsListedAsAnExperiment() {
    CameraInfo info = provider.list().get(0);

    assertEquals("evk4:1-3", info.id());
    assertTrue(info.canOpen());
    assertTrue(info.note().startsWith("experimental"));
  }

  @Test
  void itTellsItsNumberStreamsAndStops() throws IOException {
    Camera camera = provider.open(provider.list().get(0), CameraOptions.DEFAULT.withReadings(true));
    StreamLog log = new StreamLog(camera);
    log.untilA(StreamStarted.class);
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
}
