package haltere.device.model;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.camera.Biases;
import haltere.core.camera.Camera;
import haltere.core.camera.CameraInfo;
import haltere.core.camera.CameraOptions.WhenFull;
import haltere.core.camera.CameraProblem;
import haltere.core.camera.CameraProblem.Kind;
import haltere.core.camera.Led;
import haltere.core.camera.TimestampReset;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.core.format.internal.aedat4.Aedat4Compression;
import haltere.core.format.internal.aedat4.Aedat4Writer;
import haltere.core.pipeline.CameraHeader;
import haltere.core.pipeline.SessionRecorder;
import haltere.core.stream.DataLost;
import haltere.core.stream.DeviceLost;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.StreamStarted;
import haltere.device.usb.UsbBus;
import haltere.device.usb.UsbDevice;
import haltere.device.usb.UsbTransport;
import haltere.testing.StreamRecorder;
import haltere.testing.usb.Dvs128Firmware;
import haltere.testing.usb.EmulatedDevice;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Clock;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Scenarios of loss, unplugging, reconnection and closing: every event is accounted for. */
abstract class LossScenarios extends CameraBench {
  LossScenarios(BusUnderTest on) {
    super(on);
  }

  @Test
  void slowConsumerLosesTheNewestEventsAndReceivesTheirCount() throws IOException {
    try (Camera camera = open(SMALL)) {
      StreamLog log = started(camera);
      sendAndLetWait(camera);
      log.drain();
      sendMore(50_000);
      log.until(() -> log.events + log.lost == firmware.eventsSent());

      assertTrue(log.lost > 10_000, log.toString());
      assertEquals(log.lost, camera.statistics().lostEvents());
      DataLost loss = log.untilA(DataLost.class);
      assertEquals(log.all.timeUs((int) (log.events - 2)), loss.fromUs(), "the oldest are whole");
      assertEquals(500_000, loss.toUs());
      assertTimesAreThoseThatWereSent(log);
    }
  }

  @Test
  void slowConsumerLosesTheOldestEventsWithDropOldest() throws IOException {
    try (Camera camera = open(SMALL.withWhenFull(WhenFull.DROP_OLDEST))) {
      StreamLog log = started(camera);
      sendAndLetWait(camera);
      log.drain();
      sendMore(50_000);
      log.until(() -> log.events + log.lost == firmware.eventsSent());

      assertTrue(log.lost > 10_000, log.toString());
      assertEquals(log.lost, camera.statistics().lostEvents());
      assertEquals(500_000, log.all.lastTimeUs());
      assertEquals(log.lost * 10, log.all.firstTimeUs());
      assertTimesAreThoseThatWereSent(log);
    }
  }

  /** Sends much more than may wait, of which nothing is taken. */
  private void sendAndLetWait(Camera camera) {
    long before = camera.statistics().bytes();
    sendEvents(50_000);
    await(() -> camera.statistics().bytes() >= before + 50_000 * 4);
  }

  private void sendMore(int from) {
    firmware.event(from * 10L, from & 127, from >> 7 & 127, (from & 1) == 0);
    firmware.endPacket();
  }

  /** Each event says by its pixel which one it is: its time must be that one's. */
  private static void assertTimesAreThoseThatWereSent(StreamLog log) {
    for (int i = 0; i < log.events; i++) {
      long index = log.all.timeUs(i) / 10;
      assertEquals(index & 127, log.all.x(i));
      assertEquals(index >> 7 & 127, log.all.y(i));
    }
  }

  // ---- Leaving and coming back

  @Test
  void unpluggingEndsTheStreamWithADeviceLostNotification() throws IOException {
    try (Camera camera = open(SMALL)) {
      StreamLog log = started(camera);
      sendEvents(1000);
      log.untilEvents(1000);
      device.unplug();
      log.untilOver();

      assertEquals(
          List.of(
              new StreamStarted(camera.geometry(), "DVS128 0042"),
              new DeviceLost("DVS128 0042 (dvs128:0042)", 9990),
              new EndOfStream(9990)),
          log.items);
      assertEquals(
          Kind.GONE,
          assertThrows(
                  CameraProblem.class,
                  () -> camera.facet(TimestampReset.class).orElseThrow().resetTimestamps())
              .kind());
    }
  }

  @Test
  void reconnectedCameraStartsANewStreamWithItsBiases() throws IOException {
    try (Camera camera = open(SMALL.withReconnect(true))) {
      StreamLog log = started(camera);
      camera.facet(Biases.class).orElseThrow().apply("slow");
      byte[] biases = firmware.biases();
      sendEvents(10);
      log.untilEvents(10);
      device.unplug();
      log.untilA(EndOfStream.class);

      Dvs128Firmware again = new Dvs128Firmware("0042");
      device = on.bus().plug(on.numbers().getAsInt(), again);
      log.until(() -> camera.statistics().streams() == 2);
      assertArrayEquals(biases, again.biases());
      again.event(3, 1, 2, true);
      again.endPacket();
      log.untilEvents(11);

      assertEquals(3, log.all.timeUs(10));
      assertEquals(0, log.lost);
    }
  }

  @Test
  void reconnectedCameraHasTheLedStateThatWasSet() throws IOException {
    try (Camera camera = open(SMALL.withReconnect(true))) {
      StreamLog log = started(camera);
      camera.facet(Led.class).orElseThrow().setLed(Led.LedState.OFF);
      device.unplug();
      log.untilA(EndOfStream.class);

      Dvs128Firmware again = new Dvs128Firmware("0042");
      device = on.bus().plug(on.numbers().getAsInt(), again);
      log.until(() -> camera.statistics().streams() == 2);

      assertTrue(again.log().contains("40:cd v=0000 i=0000 n=0"), again.log().toString());
    }
  }

  @Test
  void recordingAcrossADisconnectionHasTwoPartsWithEachEventOnce(@TempDir Path folder)
      throws IOException {
    Camera camera = open(SMALL.withReconnect(true));
    SessionRecorder session = session(camera, folder.resolve("night.aedat4"));
    takeUntil(camera, session, () -> camera.statistics().streams() == 1);
    await(firmware::isStreaming);
    camera.facet(Biases.class).orElseThrow().set("Pr", 300);
    sendEvents(1000);
    takeUntil(camera, session, () -> camera.statistics().events() == 1000);
    device.unplug();
    Dvs128Firmware again = new Dvs128Firmware("0042");
    device = on.bus().plug(on.numbers().getAsInt(), again);
    takeUntil(camera, session, () -> camera.statistics().streams() == 2);
    for (int i = 0; i < 500; i++) {
      again.event(i * 7L, i & 127, 5, true);
    }
    again.endPacket();
    takeUntil(camera, session, () -> camera.statistics().events() == 1500);
    camera.close();
    camera.drainTo(session);
    List<SessionRecorder.Part> parts = session.finish();

    assertEquals(2, parts.size());
    StreamRecorder first = read(parts.get(0).file(), "300 2^-24");
    StreamRecorder second = read(parts.get(1).file(), "300 2^-24");
    assertEquals(firmware.eventsSent(), first.events().size());
    assertEquals(again.eventsSent(), second.events().size());
    assertEquals(9990, first.events().lastTimeUs());
    assertEquals(0, second.events().firstTimeUs());
    assertEquals(499 * 7, second.events().lastTimeUs());
  }

  private static SessionRecorder session(Camera camera, Path file) {
    return new SessionRecorder(
        file,
        camera.geometry(),
        (part, metadata) ->
            Aedat4Writer.createInPlace(
                part,
                new WriteOptions(camera.geometry(), false, Optional.empty(), metadata),
                Aedat4Compression.LZ4),
        SessionRecorder.Limits.DEFAULT,
        new CameraHeader(camera, Optional::empty, System::nanoTime, Clock.systemUTC()),
        () -> Long.MAX_VALUE);
  }

  private static void takeUntil(Camera camera, SessionRecorder session, BooleanSupplier condition)
      throws IOException {
    while (!condition.getAsBoolean()) {
      if (camera.await(TimeUnit.MILLISECONDS.toNanos(5))) {
        camera.next(session);
      }
    }
  }

  private static StreamRecorder read(Path part, String bias) throws IOException {
    StreamRecorder all = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(part)) {
      assertEquals("DVS128 0042", reader.metadata().get("camera"));
      assertEquals(bias, reader.metadata().get("camera.bias.Pr"));
      reader.drainTo(all);
    }
    return all;
  }

  /** Looks for a camera so seldom that it does not, for a test. */
  private static final long NEVER = TimeUnit.HOURS.toNanos(1);

  @Test
  void reconnectedCameraIsFoundByBusNotificationsWithoutPolling() throws IOException {
    provider = lookingEvery(on.bus().bus(), new SearchSchedule.Pace(NEVER, NEVER));
    assertThatItIsFoundAgain();
  }

  @Test
  void reconnectedCameraIsFoundByPollingWithoutBusNotifications() throws IOException {
    provider =
        lookingEvery(
            new SilentBus(on.bus().bus()),
            new SearchSchedule.Pace(TimeUnit.MILLISECONDS.toNanos(5), NEVER));
    assertThatItIsFoundAgain();
  }

  private static UsbCameraProvider lookingEvery(UsbBus bus, SearchSchedule.Pace pace) {
    return new UsbCameraProvider(() -> bus, LockSupport::parkNanos, pace);
  }

  private void assertThatItIsFoundAgain() throws IOException {
    try (Camera camera = open(SMALL.withReconnect(true))) {
      StreamLog log = started(camera);
      for (int time = 2; time <= 4; time++) {
        int streams = time;
        device.unplug();
        log.until(() -> log.ends() == streams - 1);
        assertFalse(camera.await(0), "it is away");
        device = on.bus().plug(on.numbers().getAsInt(), new Dvs128Firmware("0042"));
        log.until(() -> camera.statistics().streams() == streams);
      }
    }
  }

  /** A bus that does not tell of changes, as libusb on Windows. */
  private record SilentBus(UsbBus bus) implements UsbBus {
    @Override
    public List<UsbDevice> devices() throws CameraProblem {
      return bus.devices();
    }

    @Override
    public UsbTransport open(UsbDevice device) throws CameraProblem {
      return bus.open(device);
    }
  }

  @Test
  void unpluggingAtAnyMomentLosesNoReceivedEvent() throws Exception {
    int times = Integer.getInteger("haltere.unplugs", 12);
    Random random = new Random(7);
    for (int i = 0; i < times; i++) {
      unplugAt(random.nextInt(3_000_000), random.nextInt(4) == 0);
    }
  }

  private void unplugAt(long afterNanos, boolean slowly) throws Exception {
    Dvs128Firmware here = new Dvs128Firmware("0099");
    EmulatedDevice there = plug(here);
    CameraInfo info =
        provider.list().stream().filter(seen -> seen.serial().equals("0099")).findFirst().get();
    try (Camera camera = provider.open(info, SMALL)) {
      StreamLog log = new StreamLog(camera, false);
      Thread sender =
          new Thread(
              () -> {
                for (int us = 0; !there.isUnplugged(); us++) {
                  here.event(us, us & 127, 1, true);
                }
              });
      log.untilA(StreamStarted.class);
      sender.start();
      long end = System.nanoTime() + afterNanos;
      while (System.nanoTime() < end) {
        if (!slowly) {
          log.drain();
        }
      }
      there.unplug();
      sender.join();
      log.untilOver();

      assertEquals(here.eventsSent(), log.events + log.lost, log::toString);
      assertEquals(0, log.unknownLosses);
    }
    await(() -> provider.list().size() == 1);
  }

  @Test
  void eventsReceivedBeforeClosingAreDelivered() throws IOException {
    Camera camera = open(SMALL.withBuffers(4, 512, 64));
    StreamLog log = started(camera);
    sendEvents(1000);
    await(() -> camera.statistics().bytes() >= 4000);
    camera.close();
    log.untilOver();

    assertEquals(1000, log.events);
    assertEquals(0, camera.statistics().lostEvents());
    assertEquals(new EndOfStream(9990), log.items.get(log.items.size() - 1));
    assertFalse(camera.await(0) && camera.next(log));
  }

  @Test
  void closingAlwaysEndsTheStream() throws Exception {
    int times = Integer.getInteger("haltere.cycles", 40);
    Random random = new Random(3);
    for (int i = 0; i < times; i++) {
      Camera camera = open(SMALL.withBuffers(8, 512, 8));
      StreamLog log = started(camera);
      Thread sender =
          new Thread(
              () -> {
                for (int us = 0; firmware.isStreaming(); us++) {
                  firmware.event(us, us & 127, 1, true);
                }
              });
      sender.start();
      Thread consumer =
          new Thread(
              () -> {
                try {
                  log.untilOver();
                } catch (IOException problem) {
                  throw new AssertionError(problem);
                }
              });
      consumer.start();
      LockSupport.parkNanos(random.nextInt(2_000_000));
      camera.close();
      consumer.join(5000);
      sender.join();

      assertFalse(consumer.isAlive(), "the consumer still waits");
      assertTrue(log.items.get(log.items.size() - 1) instanceof EndOfStream, log.toString());
    }
  }
}
