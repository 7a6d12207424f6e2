package haltere.device.model;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.camera.Biases;
import haltere.core.camera.Camera;
import haltere.core.camera.CameraInfo;
import haltere.core.camera.CameraOptions;
import haltere.core.camera.CameraOptions.WhenFull;
import haltere.core.camera.CameraProblem;
import haltere.core.camera.CameraProblem.Kind;
import haltere.core.camera.ClockSync;
import haltere.core.camera.Configuration;
import haltere.core.camera.Led;
import haltere.core.camera.TimestampReset;
import haltere.core.event.Trigger;
import haltere.core.stream.DataLost;
import haltere.core.stream.DeviceLost;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamStarted;
import haltere.device.usb.UsbTransport;
import haltere.testing.usb.Dvs128Firmware;
import haltere.testing.usb.EmulatedDevice;
import haltere.testing.usb.TestBus;
import java.io.IOException;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * What a driver has to live through, whatever the bus. A DVS128 is plugged in anew for each test.
 */
@Timeout(600)
abstract class CameraScenarios {
  static final CameraOptions SMALL =
      new CameraOptions(4, 512, 64, WhenFull.DROP_NEWEST, true, false);
  private static final int ENDPOINT = Dvs128Firmware.ENDPOINT;

  private final Dvs128Firmware firmware = new Dvs128Firmware("0042");
  private UsbCameraProvider provider;
  private EmulatedDevice device;
  private int numberOfDevice;
  private int lastNumber;

  /** The bus of all tests of this class. */
  abstract TestBus bus();

  /** An address that no test has used lately. */
  abstract int nextNumber();

  @BeforeEach
  void plugIn() {
    provider = new UsbCameraProvider(bus().bus());
    device = plug(firmware);
    numberOfDevice = lastNumber;
  }

  @AfterEach
  void unplug() {
    device.unplug();
    await(() -> provider.list().isEmpty());
  }

  private EmulatedDevice plug(Dvs128Firmware plugged) {
    int before = provider.list().size();
    EmulatedDevice fresh = bus().plug(freeNumber(), plugged);
    await(() -> provider.list().size() > before);
    return fresh;
  }

  /** Many come and go while one stays plugged in. */
  private int freeNumber() {
    int number = nextNumber();
    if (device != null && !device.isUnplugged() && number == numberOfDevice) {
      number = nextNumber();
    }
    lastNumber = number;
    return number;
  }

  private Camera open(CameraOptions options) throws CameraProblem {
    return provider.open(provider.list().get(0), options);
  }

  /** Opens and starts it, so that its clock is at 0 and nothing is under way. */
  private StreamLog started(Camera camera) throws IOException {
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

  private void sendEvents(int count) {
    for (int i = 0; i < count; i++) {
      firmware.event(i * 10L, i & 127, i >> 7 & 127, (i & 1) == 0);
    }
    firmware.endPacket();
  }

  // ---- Finding and opening

  @Test
  void aCameraIsListedWithItsNumber() {
    List<CameraInfo> list = provider.list();

    assertEquals(1, list.size());
    assertEquals("dvs128:0042", list.get(0).id());
    assertEquals("DVS128", list.get(0).model());
    assertEquals("0042", list.get(0).serial());
    assertEquals("128x128", list.get(0).geometry().toString());
    assertTrue(list.get(0).canOpen());
  }

  @Test
  void aCameraThatIsUnpluggedIsNotListedAnyMore() {
    device.unplug();

    await(() -> provider.list().isEmpty());
    device = plug(firmware);
    assertEquals("dvs128:0042", provider.list().get(0).id());
  }

  @Test
  void aCameraThatAnotherProgramHasIsListedAndNotOpened() {
    firmware.setBusy(true);

    assertFalse(provider.list().get(0).canOpen());
    assertTrue(provider.list().get(0).note().contains("another program"));
    assertEquals(Kind.BUSY, assertThrows(CameraProblem.class, () -> open(SMALL)).kind());
  }

  @Test
  void whoMayNotOpenItIsToldTheRuleAndTheCommand() {
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
  void twoCamerasStreamAtOnceAndTheirClocksAreRelated() throws IOException {
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
  void biasesReachTheChip() throws IOException {
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
  void aRefusedRequestSaysSoAndChangesNothing() throws IOException {
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
  void aDeafCameraIsGivenUpAndClosedInTime() throws IOException {
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
  void lightSyncAndClockAreSetAndAsked() throws IOException {
    try (Camera camera = open(SMALL)) {
      camera.facet(Led.class).orElseThrow().setLed(Led.State.BLINKING);
      camera.facet(ClockSync.class).orElseThrow().setMaster(false);

      assertFalse(camera.facet(ClockSync.class).orElseThrow().isMaster());
      assertTrue(firmware.log().contains("40:cd v=0002 i=0000 n=0"));
    }
  }

  // ---- Streaming

  @Test
  void eventsTriggersWrapsAndResetsComeInOrder() throws IOException {
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
  void whatTheCameraKeptFromBeforeItWasStartedIsLeftOut() throws IOException {
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
  void aLostWrapIsMadeUpForWhereTimeFalls() throws IOException {
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
      assertEquals(1, camera.statistics().oddWords());
    }
  }

  @Test
  void shortFullAndEmptyPacketsAllArrive() throws IOException {
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
  void garbageIsCountedAndTheStreamGoesOn() throws IOException {
    try (Camera camera = open(SMALL)) {
      StreamLog log = started(camera);
      byte[] junk = new byte[511];
      new Random(1).nextBytes(junk);
      firmware.garbage(junk);
      firmware.endPacket();
      sendEvents(100);
      log.until(() -> log.events == firmware.eventsSent() && log.events >= 100);

      assertTrue(camera.statistics().oddWords() > 0);
    }
  }

  @Test
  void aPacketThatIsTooLongIsToldAndTheStreamGoesOn() throws IOException {
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
  void aHaltedEndpointIsStartedAgainAndLosesNothing() throws IOException {
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
  void anErrorOnTheBusIsToldAndTheStreamGoesOn() throws IOException {
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
  void errorsThatDoNotEndAreAnUnpluggedCamera() throws IOException {
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
  void aBulkReadThatNobodyAnswersIsGivenUp() throws IOException {
    try (UsbTransport transport = bus().bus().open(bus().bus().devices().get(0))) {
      transport.claim();

      CameraProblem problem =
          assertThrows(CameraProblem.class, () -> transport.read(ENDPOINT, 512));

      assertEquals(Kind.TIMED_OUT, problem.kind());
    }
  }

  // ---- Loss

  @Test
  void aSlowConsumerLosesTheNewestAndIsToldHowMany() throws IOException {
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
  void aSlowConsumerMayLoseTheOldestInstead() throws IOException {
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
  void unpluggingEndsTheStreamWithAClearLine() throws IOException {
    try (Camera camera = open(SMALL)) {
      StreamLog log = started(camera);
      sendEvents(1000);
      log.untilEvents(1000);
      device.unplug();
      log.untilOver();

      assertEquals(
          List.of(
              new StreamStarted(camera.geometry(), "DVS128 0042"),
              new DeviceLost("DVS128 0042 was unplugged (dvs128:0042)", 9990),
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
  void pluggedInAgainItGoesOnWithANewStreamAndItsSettings() throws IOException {
    try (Camera camera = open(SMALL.withReconnect(true))) {
      StreamLog log = started(camera);
      camera.facet(Biases.class).orElseThrow().apply("slow");
      byte[] biases = firmware.biases();
      sendEvents(10);
      log.untilEvents(10);
      device.unplug();
      log.untilA(EndOfStream.class);

      Dvs128Firmware again = new Dvs128Firmware("0042");
      device = bus().plug(nextNumber(), again);
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
  void unpluggedAtAnyMomentNothingThatArrivedIsLost() throws Exception {
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
  void closingEndsTheStreamAtOnceAndNeverHangs() throws Exception {
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
