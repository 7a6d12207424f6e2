package haltere.device.model;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.core.camera.Camera;
import haltere.core.camera.CameraInfo;
import haltere.testing.usb.Dvs128Firmware;
import haltere.testing.usb.EmulatedDevice;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.Test;

/** Scenarios of several cameras at once, each with its own consumer thread. */
abstract class ManyCameraScenarios extends CameraBench {
  private static final int EVENTS = 20_000;
  private static final int PER_PACKET = 100;
  private static final Executor THREAD_EACH = task -> new Thread(task).start();

  ManyCameraScenarios(BusUnderTest on) {
    super(on);
  }

  /** A camera, what it sends and what came of it. */
  private record Used(Dvs128Firmware firmware, Camera camera, StreamLog log) {
    void send(int from, int to) {
      for (int i = from; i < to; i++) {
        firmware.event(i * 10L, i & 127, 1, true);
        if (i % PER_PACKET == 0) {
          firmware.endPacket();
          LockSupport.parkNanos(TimeUnit.MICROSECONDS.toNanos(50));
        }
      }
      firmware.endPacket();
    }

    CompletableFuture<Void> consume(int events) {
      return CompletableFuture.runAsync(
          () -> {
            try {
              log.until(() -> log.events + log.lost >= events);
            } catch (IOException problem) {
              throw new UncheckedIOException(problem);
            }
          },
          THREAD_EACH);
    }
  }

  private Used use(Dvs128Firmware sender, CameraInfo info) throws IOException {
    Camera camera = provider.open(info, SMALL);
    return new Used(sender, camera, started(camera));
  }

  private CameraInfo seen(String serial) {
    return provider.list().stream()
        .filter(info -> info.serial().equals(serial))
        .findFirst()
        .orElseThrow();
  }

  @Test
  void twoCamerasDeliverAllOfTheirEventsEvenIfOneIsClosed() throws Exception {
    Dvs128Firmware other = new Dvs128Firmware("0043");
    EmulatedDevice otherDevice = plug(other);
    Used one = use(firmware, seen("0042"));
    Used two = use(other, seen("0043"));
    List<CompletableFuture<?>> work = new ArrayList<>();
    for (Used each : List.of(one, two)) {
      work.add(each.consume(EVENTS));
      work.add(CompletableFuture.runAsync(() -> each.send(0, EVENTS), THREAD_EACH));
    }
    for (CompletableFuture<?> each : work) {
      each.get(50, TimeUnit.SECONDS);
    }
    assertEquals(EVENTS, one.log.events + one.log.lost);

    CompletableFuture<Void> rest = two.consume(2 * EVENTS);
    CompletableFuture<Void> sent =
        CompletableFuture.runAsync(() -> two.send(EVENTS, 2 * EVENTS), THREAD_EACH);
    one.camera.close();
    rest.get(50, TimeUnit.SECONDS);
    sent.get(50, TimeUnit.SECONDS);
    two.camera.close();

    assertEquals(2 * EVENTS, two.log.events + two.log.lost);
    otherDevice.unplug();
    await(() -> provider.list().size() == 1);
  }
}
