package haltere.device.model;

import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.camera.Camera;
import haltere.core.camera.CameraOptions;
import haltere.core.camera.CameraOptions.WhenFull;
import haltere.core.camera.CameraProblem;
import haltere.core.stream.StreamStarted;
import haltere.testing.usb.Dvs128Firmware;
import haltere.testing.usb.EmulatedDevice;
import java.io.IOException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Timeout;

/** A DVS128 that is plugged in anew for each test, whatever the bus. */
@Timeout(600)
abstract class CameraBench {
  static final CameraOptions SMALL =
      new CameraOptions(4, 512, 64, WhenFull.DROP_NEWEST, true, false);
  static final int ENDPOINT = Dvs128Firmware.ENDPOINT;

  final BusUnderTest on;
  final Dvs128Firmware firmware = new Dvs128Firmware("0042");
  UsbCameraProvider provider;
  EmulatedDevice device;
  private int numberOfDevice;
  private int lastNumber;

  CameraBench(BusUnderTest on) {
    this.on = on;
  }

  @BeforeEach
  void plugIn() {
    provider = new UsbCameraProvider(on.bus().bus());
    device = plug(firmware);
    numberOfDevice = lastNumber;
  }

  @AfterEach
  void unplug() {
    device.unplug();
    await(() -> provider.list().isEmpty());
  }

  EmulatedDevice plug(Dvs128Firmware plugged) {
    int before = provider.list().size();
    EmulatedDevice fresh = on.bus().plug(freeNumber(), plugged);
    await(() -> provider.list().size() > before);
    return fresh;
  }

  /** Many come and go while one stays plugged in. */
  private int freeNumber() {
    int number = on.numbers().getAsInt();
    if (device != null && !device.isUnplugged() && number == numberOfDevice) {
      number = on.numbers().getAsInt();
    }
    lastNumber = number;
    return number;
  }

  Camera open(CameraOptions options) throws CameraProblem {
    return provider.open(provider.list().get(0), options);
  }

  /** Opens and starts it, so that its clock is at 0 and nothing is under way. */
  StreamLog started(Camera camera) throws IOException {
    StreamLog log = new StreamLog(camera);
    log.untilA(StreamStarted.class);
    await(firmware::isStreaming);
    return log;
  }

  static void await(BooleanSupplier condition) {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(10);
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < end, "waited in vain");
      LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(1));
    }
  }

  void sendEvents(int count) {
    for (int i = 0; i < count; i++) {
      firmware.event(i * 10L, i & 127, i >> 7 & 127, (i & 1) == 0);
    }
    firmware.endPacket();
  }
}
