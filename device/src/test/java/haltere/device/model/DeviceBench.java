package haltere.device.model;

import haltere.core.camera.Camera;
import haltere.core.camera.CameraOptions;
import haltere.core.camera.CameraProblem;
import haltere.core.stream.StreamStarted;
import haltere.testing.usb.EmulatedDevice;
import haltere.testing.usb.Firmware;
import java.io.IOException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Timeout;

/**
 * A camera of one kind that is plugged in anew for each test, whatever the bus, and need not be
 * waited for while it gets ready.
 *
 * @param <F> what is in it
 */
@Timeout(60)
abstract class DeviceBench<F extends Firmware> {
  final BusUnderTest on;
  final UsbCameraProvider provider;
  F firmware;
  EmulatedDevice device;

  DeviceBench(BusUnderTest on) {
    this.on = on;
    provider = new UsbCameraProvider(on.bus()::bus, nanos -> {}, SearchSchedule.Pace.DEFAULT);
  }

  /** A new one, as it leaves the maker. */
  abstract F newFirmware();

  @BeforeEach
  void plugIn() {
    firmware = newFirmware();
    plug(firmware);
  }

  void plug(F plugged) {
    device = on.bus().plug(on.numbers().getAsInt(), plugged);
    CameraBench.await(() -> !provider.list().isEmpty());
  }

  @AfterEach
  void unplug() {
    device.unplug();
    CameraBench.await(() -> provider.list().isEmpty());
  }

  Camera open(CameraOptions options) throws CameraProblem {
    return provider.open(provider.list().get(0), options);
  }

  StreamLog started(Camera camera) throws IOException {
    StreamLog log = new StreamLog(camera);
    log.untilA(StreamStarted.class);
    return log;
  }
}
