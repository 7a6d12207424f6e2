package haltere.device.model;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.camera.Biases;
import haltere.core.camera.Camera;
import haltere.core.camera.CameraInfo;
import haltere.core.camera.CameraProblem;
import haltere.core.camera.CameraProblem.Kind;
import haltere.core.camera.CameraProvider;
import haltere.core.camera.ClockSync;
import haltere.core.camera.Configuration;
import haltere.core.camera.Led;
import haltere.core.camera.TimestampReset;
import haltere.core.event.Trigger;
import haltere.core.stream.DataLost;
import haltere.core.stream.DeviceLost;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamStarted;
import haltere.device.usb.UsbTransport;
import haltere.testing.usb.Dvs128Firmware;
import haltere.testing.usb.EmulatedDevice;
import java.io.IOException;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;

/** Scenarios of a driver on any bus: discovery, requests, streaming, faults. */
abstract class CameraScenarios extends CameraBench {
  CameraScenarios(BusUnderTest on) {
    super(on);
  }

  // ---- Finding and opening

  @Test
  void connectedCameraIsListedWithModelAndSerialNumber() {
    List<CameraInfo> list = provider.list();

    assertEquals(1, list.size());
    assertEquals("dvs128:0042", list.get(0).id());
    assertEquals("DVS128", list.get(0).model());
    assertEquals("0042", list.get(0).serial());
    assertEquals("128x128", list.get(0).geometry().toString());
    assertTrue(list.get(0).canOpen());
  }

  @Test
  void unpluggedCameraIsNoLongerListed() {
    device.unplug();

    await(() -> provider.list().isEmpty());
    device = plug(firmware);
    assertEquals("dvs128:0042", provider.list().get(0).id());
  }

  @Test
  void watcherIsNotifiedWhenCamerasArePluggedInOrUnplugged() {
    AtomicInteger notifications = new AtomicInteger();
    try (CameraProvider.Watch watch =
        provider.watch(notifications::incrementAndGet).orElseThrow()) {
      assertNotNull(watch);
      device.unplug();
      await(() -> notifications.get() >= 1);
      await(() -> provider.list().isEmpty());
      int before = notifications.get();
      device = plug(firmware);
      await(() -> notifications.get() > before);
    }
  }

  @Test
  void cameraInUseByAnotherProgramIsListedButCannotBeOpened() {
    firmware.setBusy(true);

    assertFalse(provider.list().get(0).canOpen());
    assertTrue(provider.list().get(0).note().contains("another program"));
    assertEquals(Kind.BUSY, assertThrows(CameraProblem.class, () -> open(SMALL)).kind());
  }

  @Test
  void missingPermissionIsReportedWithUdevRuleAndCommand() {
    device.setForbidden(true);

    CameraInfo info = provider.list().get(0);
    assertFalse(info.canOpen());
    assertTrue(
        info.note()
            .contains(
                "echo 'SUBSYSTEM==\"usb\", ATTR{idVendor}==\"152a\", ATTR{idProduct}==\"8400\","
                    + " MODE=\"0666\", TAG+=\"uaccess\"' | sudo tee -a"),
        info.note());
    assertEquals(Kind.NOT_PERMITTED, assertThrows(CameraProblem.class, () -> open(SMALL)).kind());
  }

  @Test
  void twoCamerasStreamAtOnceWithRelatedClocks() throws IOException {
    Dvs128Firmware second = new Dvs128Firmware("0043");
    EmulatedDevice other = plug(second);
    try (Camera one = provider.open(provider.list().get(0), SMALL);
        Camera two = provider.open(provider.list().get(1), SMALL)) {
      StreamLog first = started(one);
      StreamLog next = new StreamLog(two);
      next.untilA(StreamStarted.class);
      firmware.event(5_000_000, 1, 1, true);
      firmware.endPacket();
      first.untilEvents(1);
      second.event(100, 2, 2, true);
      second.endPacket();
      next.untilEvents(1);

      long later =
          one.clockRelation().orElseThrow().onClockOf(two.clockRelation().orElseThrow(), 5_000_000);
      assertTrue(later <= 100 && later > 100 - 5_000_000, "related as " + later + " us");
      assertEquals("dvs128:0043", two.info().id());
    } finally {
      other.unplug();
    }
  }

  // ---- Requests

  @Test
  void biasesAreSentToTheChip() throws IOException {
    try (Camera camera = open(SMALL)) {
      Biases biases = camera.facet(Biases.class).orElseThrow();
      biases.apply("slow");
      biases.set("Pr", 0x010203);

      byte[] sent = firmware.biases();
      assertEquals(36, sent.length);
      assertArrayEquals(new byte[] {0, 0, 54}, java.util.Arrays.copyOf(sent, 3));
      assertArrayEquals(new byte[] {1, 2, 3}, java.util.Arrays.copyOfRange(sent, 33, 36));
      assertTrue(
          camera
              .facet(Configuration.class)
              .orElseThrow()
              .text()
              .startsWith("camera = DVS128 0042\n"));
    }
  }

  @Test
  void refusedRequestIsReportedAndLeavesBiasesUnchanged() throws IOException {
    try (Camera camera = open(SMALL)) {
      Biases biases = camera.facet(Biases.class).orElseThrow();
      double before = biases.get("Pr");
      firmware.refuseBiases(true);

      CameraProblem problem = assertThrows(CameraProblem.class, () -> biases.set("Pr", 7));

      assertEquals(Kind.REFUSED, problem.kind());
      assertEquals(before, biases.get("Pr"));
    }
  }

  @Test
  void unresponsiveCameraTimesOutAndIsClosedInTime() throws IOException {
    long start = System.nanoTime();
    try (Camera camera = open(SMALL)) {
      started(camera);
      device.setDeaf(true);
      CameraProblem problem =
          assertThrows(
              CameraProblem.class,
              () -> camera.facet(TimestampReset.class).orElseThrow().resetTimestamps());
      assertEquals(Kind.TIMED_OUT, problem.kind());
    }
    assertTrue(System.nanoTime() - start < TimeUnit.SECONDS.toNanos(5), "it took too long");
    device.setDeaf(false);
  }

  @Test
  void ledAndClockSyncAreSetAndReadBack() throws IOException {
    try (Camera camera = open(SMALL)) {
      camera.facet(Led.class).orElseThrow().setLed(Led.LedState.BLINKING);
      camera.facet(ClockSync.class).orElseThrow().setMaster(false);

      assertFalse(camera.facet(ClockSync.class).orElseThrow().isMaster());
      assertTrue(firmware.log().contains("40:cd v=0002 i=0000 n=0"));
    }
  }

  // ---- Streaming

  @Test
  void eventsTriggersWrapsAndResetsAreDeliveredInOrder() throws IOException {
    try (Camera camera = open(SMALL)) {
      StreamLog log = started(camera);
      firmware.event(5, 1, 2, true);
      firmware.event(16_390, 127, 0, false);
      firmware.event(100_000, 64, 65, true);
      firmware.trigger(100_001);
      firmware.resetTimestamps();
      firmware.event(7, 3, 4, false);
      firmware.endPacket();
      log.untilEvents(4);

      assertArrayEquals(
          new long[] {5, 16_390, 100_000, 7}, java.util.Arrays.copyOf(log.all.timesUs(), 4));
      assertEquals(64, log.all.x(2));
      assertEquals(65, log.all.y(2));
      assertFalse(log.all.isOn(1));
      assertEquals(
          new Trigger(100_001, Trigger.Source.EXTERNAL_INPUT, Trigger.Edge.FALLING, 0),
          log.items.get(1));
      assertEquals(
          new Reset(Reset.Cause.CLOCK_RESTARTED, 100_000, Long.MIN_VALUE), log.items.get(2));
    }
  }

  @Test
  void dataQueuedInTheCameraBeforeTheStartIsDiscarded() throws IOException {
    firmware.event(77, 1, 1, true);
    firmware.endPacket();
    firmware.event(99, 2, 2, true); // in the camera, not yet in its queue

    try (Camera camera = open(SMALL)) {
      StreamLog log = started(camera);
      firmware.event(5, 3, 3, true);
      firmware.endPacket();
      log.untilEvents(1);

      assertEquals(5, log.all.timeUs(0));
      assertEquals(1, log.items.size(), log.items.toString());
    }
  }

  @Test
  void lostTimestampWrapIsCorrectedWhenTimestampsDecrease() throws IOException {
    try (Camera camera = open(SMALL)) {
      StreamLog log = started(camera);
      firmware.event(16_000, 1, 1, true);
      firmware.loseWraps(1);
      firmware.event(16_500, 1, 1, true);
      firmware.event(40_000, 1, 1, true);
      firmware.endPacket();
      log.untilEvents(3);

      assertArrayEquals(
          new long[] {16_000, 16_500, 40_000}, java.util.Arrays.copyOf(log.all.timesUs(), 3));
      assertEquals(1, camera.statistics().unknownWords());
    }
  }

  @Test
  void shortFullAndEmptyUsbPacketsAreAllReceived() throws IOException {
    try (Camera camera = open(SMALL.withBuffers(2, 1024, 64))) {
      StreamLog log = started(camera);
      device.send(ENDPOINT, new byte[512]);
      device.send(ENDPOINT, new byte[512]);
      log.untilEvents(256);
      device.send(ENDPOINT, new byte[8]);
      log.untilEvents(258);
      device.send(ENDPOINT, new byte[0]);
      device.send(ENDPOINT, new byte[4]);
      log.untilEvents(259);

      assertEquals(firmware.eventsSent(), log.events);
    }
  }

  @Test
  void invalidWordsAreCountedAndTheStreamContinues() throws IOException {
    try (Camera camera = open(SMALL)) {
      StreamLog log = started(camera);
      byte[] junk = new byte[511];
      new Random(1).nextBytes(junk);
      firmware.garbage(junk);
      firmware.endPacket();
      sendEvents(100);
      log.until(() -> log.events == firmware.eventsSent() && log.events >= 100);

      assertTrue(camera.statistics().unknownWords() > 0);
    }
  }

  @Test
  void oversizedPacketIsReportedAsLossAndTheStreamContinues() throws IOException {
    try (Camera camera = open(SMALL.withBuffers(2, 100, 64))) {
      StreamLog log = started(camera);
      device.send(ENDPOINT, new byte[512]);
      log.until(() -> camera.statistics().brokenTransfers() == 1);
      device.send(ENDPOINT, new byte[4]);
      log.untilEvents(1);

      DataLost loss = log.untilA(DataLost.class);
      assertEquals(-1, loss.estimatedEvents());
      assertTrue(loss.place().contains("failed"));
    }
  }

  @Test
  void haltedEndpointIsRestartedWithoutLoss() throws IOException {
    try (Camera camera = open(SMALL)) {
      StreamLog log = started(camera);
      await(() -> device.waiting(ENDPOINT) == 4);
      device.halt(ENDPOINT, true);
      sendEvents(1000);
      log.untilEvents(1000);

      assertEquals(1000, firmware.eventsSent());
      assertTrue(log.unknownLosses > 0);
    }
  }

  @Test
  void busErrorIsReportedAsLossAndTheStreamContinues() throws IOException {
    try (Camera camera = open(SMALL)) {
      StreamLog log = started(camera);
      await(() -> device.waiting(ENDPOINT) == 4);
      device.failNext(ENDPOINT, EmulatedDevice.EPROTO);
      await(() -> device.waiting(ENDPOINT) == 4);
      sendEvents(1000);
      log.untilEvents(1000);

      assertEquals(1, log.unknownLosses);
      assertEquals(1, camera.statistics().brokenTransfers());
    }
  }

  @Test
  void persistentBusErrorsCountAsUnplugging() throws IOException {
    try (Camera camera = open(SMALL)) {
      StreamLog log = started(camera);
      for (int i = 0; i < 17; i++) {
        await(() -> device.waiting(ENDPOINT) == 4);
        device.failNext(ENDPOINT, EmulatedDevice.EPROTO);
      }
      log.untilA(DeviceLost.class);
    }
  }

  @Test
  void unansweredBulkReadTimesOut() throws IOException {
    try (UsbTransport transport = on.bus().bus().open(on.bus().bus().devices().get(0))) {
      transport.claim();

      CameraProblem problem =
          assertThrows(CameraProblem.class, () -> transport.read(ENDPOINT, 512));

      assertEquals(Kind.TIMED_OUT, problem.kind());
    }
  }
}
