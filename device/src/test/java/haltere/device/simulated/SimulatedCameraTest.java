package haltere.device.simulated;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.camera.BiasSliders;
import haltere.core.camera.BiasSliders.Slider;
import haltere.core.camera.Biases;
import haltere.core.camera.Camera;
import haltere.core.camera.CameraInfo;
import haltere.core.camera.CameraOptions;
import haltere.core.camera.CameraOptions.WhenFull;
import haltere.core.camera.CameraProblem;
import haltere.core.camera.CameraProvider;
import haltere.core.camera.CameraStatistics;
import haltere.core.camera.Cameras;
import haltere.core.camera.ClockRelation;
import haltere.core.camera.Configuration;
import haltere.core.camera.RegionOfInterest;
import haltere.core.camera.RegionOfInterest.Region;
import haltere.core.camera.TimestampReset;
import haltere.core.event.EventPacket;
import haltere.core.simulation.Scenes;
import haltere.core.simulation.internal.dots.MovingDotsSceneProvider;
import haltere.core.simulation.internal.fly.FlyScene;
import haltere.core.simulation.internal.fly.FlySceneSettings;
import haltere.core.stream.DataLost;
import haltere.core.stream.DeviceLost;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamGrammar;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import haltere.testing.ManualClock;
import haltere.testing.ServiceFiles;
import haltere.testing.StreamRecorder;
import haltere.testing.Waiting;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class SimulatedCameraTest {
  private static final long MS = 1_000_000;

  private final ManualClock time = new ManualClock();
  private final CameraProvider provider = new SimulatedCameraProvider(time, () -> time);
  private final Cameras cameras = new Cameras(List.of(provider));
  private final StreamRecorder recorder = new StreamRecorder();
  private final StreamGrammar stream = new StreamGrammar(recorder);

  @BeforeEach
  void startTheClockAnywhere() {
    time.advance(123_456_789_012L);
  }

  private Camera open(CameraOptions options) throws CameraProblem {
    return cameras.open("simulated:fly", options);
  }

  private Camera open() throws CameraProblem {
    return open(CameraOptions.DEFAULT);
  }

  /** Pulls for some milliseconds of the clock. */
  private void pull(Camera camera, StreamHandler handler, long ms) throws IOException {
    long until = time.getAsLong() + ms * MS;
    while (time.getAsLong() < until) {
      camera.next(handler);
    }
  }

  private static EventPacket sceneEvents(int count) {
    FlyScene scene = new FlyScene(FlySceneSettings.defaults());
    StreamRecorder all = new StreamRecorder();
    while (all.events().size() < count) {
      scene.next(all);
    }
    return all.events();
  }

  /** The pixels of the scene's events in order, whatever their times. */
  private static void assertScenesEvents(EventPacket events) {
    EventPacket expected = sceneEvents(events.size());
    for (int i = 0; i < events.size(); i++) {
      assertEquals(expected.address(i), events.address(i), "event " + i);
    }
  }

  @Test
  void serviceFileNamesEveryProvider() {
    assertTrue(
        ServiceFiles.registered(CameraProvider.class)
            .containsAll(
                ServiceFiles.implementations(CameraProvider.class, SimulatedCameraProvider.class)));
  }

  @Test
  void everySceneIsListedAsACamera() {
    List<String> ids = provider.list().stream().map(CameraInfo::id).toList();
    assertEquals(Scenes.all().keySet().stream().map(name -> "simulated:" + name).toList(), ids);
    assertTrue(ids.containsAll(List.of("simulated:fly", "simulated:road")));
    assertFalse(provider.isPhysical());
    assertTrue(provider.list().stream().allMatch(CameraInfo::canOpen));
    CameraProblem problem =
        assertThrows(
            CameraProblem.class, () -> cameras.open("simulated:moon", CameraOptions.DEFAULT));
    assertEquals(CameraProblem.Kind.NOT_FOUND, problem.kind());
    assertTrue(problem.getMessage().contains("simulated:road"), problem.getMessage());
  }

  @Test
  void eventsOfTheSceneAreDeliveredAtTheirTimes() throws IOException {
    try (Camera camera = open()) {
      long begin = time.getAsLong();
      pull(
          camera,
          new StreamHandler() {
            @Override
            public void packet(EventPacket packet) {
              long passedUs = (time.getAsLong() - begin) / 1000;
              assertTrue(packet.lastTimeUs() < passedUs, "an event came before its time");
              assertTrue(packet.timeUs(0) >= passedUs - 1000, "an event came too late");
              stream.packet(packet);
            }

            @Override
            public void notified(StreamNotification notification) {
              stream.notified(notification);
            }
          },
          200);
      EventPacket events = recorder.events();
      assertTrue(events.size() > 1000);
      EventPacket expected = sceneEvents(events.size());
      for (int i = 0; i < events.size(); i++) {
        assertEquals(expected.timeUs(i), events.timeUs(i));
        assertEquals(expected.address(i), events.address(i));
      }
      assertEquals(
          List.of(new StreamStarted(camera.geometry(), "simulated:fly")),
          recorder.notifications(StreamStarted.class));
      CameraStatistics statistics = camera.statistics();
      assertEquals(events.size(), statistics.events());
      assertEquals(0, statistics.lostEvents());
      assertEquals(1, statistics.streams());
      assertTrue(statistics.maxLatencyUs() <= 1000, statistics.toString());
    }
  }

  @Test
  void slowConsumerReceivesCountAndPlaceOfLostEvents() throws IOException {
    for (WhenFull whenFull : WhenFull.values()) {
      StreamRecorder got = new StreamRecorder();
      StreamGrammar checked = new StreamGrammar(got);
      Camera camera = open(CameraOptions.DEFAULT.withWhenFull(whenFull).withBuffers(0, 0, 20));
      for (int i = 0; i < 60; i++) {
        camera.next(checked);
        time.advance(7 * MS);
      }
      assertTrue(camera.statistics().waiting() <= 20);
      camera.close();
      while (camera.next(checked)) {
        // what waits
      }
      CameraStatistics statistics = camera.statistics();
      long reported = 0;
      for (DataLost lost : got.notifications(DataLost.class)) {
        reported += lost.estimatedEvents();
        assertTrue(lost.place().startsWith("simulated:fly"), lost.place());
      }
      assertTrue(reported > 0);
      assertEquals(reported, statistics.lostEvents());
      assertEquals(got.events().size(), statistics.events());
      assertEquals(statistics.bytes() / 4, reported + statistics.events());
      assertTrue(statistics.lostTransfers() > 0 && statistics.maxWaiting() <= 20);
    }
  }

  @Test
  void clockResetLosesNoEvent() throws IOException {
    try (Camera camera = open()) {
      pull(camera, stream, 50);
      camera.facet(TimestampReset.class).orElseThrow().resetTimestamps();
      pull(camera, stream, 50);
      List<Reset> resets = recorder.notifications(Reset.class);
      assertEquals(1, resets.size());
      assertEquals(Reset.Cause.CLOCK_RESTARTED, resets.get(0).cause());
      int border = recorder.notifications().get(1).eventsBefore();
      EventPacket events = recorder.events();
      assertEquals(events.timeUs(border - 1), resets.get(0).lastUs());
      assertTrue(events.timeUs(border) < 2000 && events.timeUs(border - 1) > 45_000);
      assertScenesEvents(events);
    }
  }

  @Test
  void unpluggingEndsTheStreamWithDeviceLost() throws IOException {
    try (Camera camera = open()) {
      pull(camera, stream, 30);
      Plug plug = camera.facet(Plug.class).orElseThrow();
      plug.unplug();
      assertFalse(plug.isPluggedIn());
      while (camera.next(stream)) {
        // to the end
      }
      assertTrue(stream.ended());
      long lastUs = recorder.events().lastTimeUs();
      assertEquals(
          List.of(new DeviceLost("simulated:fly", lastUs)),
          recorder.notifications(DeviceLost.class));
      assertTrue(camera.await(0));
      assertThrows(
          CameraProblem.class,
          () -> camera.facet(TimestampReset.class).orElseThrow().resetTimestamps());
    }
  }

  @Test
  void reconnectingStartsANewStreamWithoutRepeatedEvents() throws IOException {
    try (Camera camera = open(CameraOptions.DEFAULT.withReconnect(true))) {
      Plug plug = camera.facet(Plug.class).orElseThrow();
      for (int part = 0; part < 4; part++) {
        pull(camera, stream, 30);
        plug.unplug();
        while (!stream.ended()) {
          camera.next(stream);
        }
        assertFalse(camera.await(10 * MS));
        time.advance(1000 * MS);
        plug.plugIn();
        camera.next(stream);
      }
      assertEquals(5, recorder.notifications(StreamStarted.class).size());
      assertEquals(4, recorder.notifications(DeviceLost.class).size());
      assertEquals(5, camera.statistics().streams());
      pull(camera, stream, 5);
      assertTrue(recorder.events().lastTimeUs() < 10_000, "the clock starts from 0");
      assertScenesEvents(recorder.events());
    }
  }

  @Test
  void closingEndsTheWaitForAnUnpluggedCamera() throws Exception {
    Camera camera = open(CameraOptions.DEFAULT.withReconnect(true));
    pull(camera, stream, 5);
    camera.facet(Plug.class).orElseThrow().unplug();
    CountDownLatch over = new CountDownLatch(1);
    Thread consumer =
        new Thread(
            () -> {
              try {
                while (camera.next(stream)) {
                  // to the end
                }
                over.countDown();
              } catch (IOException unexpected) {
                throw new IllegalStateException(unexpected);
              }
            });
    consumer.start();
    Waiting.until("the end of the stream", stream::ended);
    camera.close();
    over.await();
    consumer.join();
    camera.close();
    assertFalse(camera.next(stream));
  }

  @Test
  void closingARunningCameraDeliversReceivedEventsAndTheEnd() throws IOException {
    Camera camera = open();
    pull(camera, stream, 20);
    camera.close();
    while (camera.next(stream)) {
      // to the end
    }
    assertTrue(stream.ended());
    assertEquals(1, recorder.notifications(EndOfStream.class).size());
  }

  @Test
  void biasesChangeTheEventRate() throws IOException {
    try (Camera camera = open()) {
      Biases biases = camera.facet(Biases.class).orElseThrow();
      pull(camera, stream, 100);
      int usual = recorder.events().size();
      biases.set("threshold", 0.8);
      assertEquals(0.8, biases.get("threshold"));
      pull(camera, stream, 20);
      int before = recorder.events().size();
      pull(camera, stream, 100);
      assertTrue(recorder.events().size() - before < usual * 0.7);
      biases.apply("default");
      assertEquals(0.2, biases.get("threshold"));
      assertEquals(List.of("default", "fast", "slow"), biases.sets());
      assertThrows(IllegalArgumentException.class, () -> biases.set("threshold", 100));
      assertThrows(IllegalArgumentException.class, () -> biases.set("nothing", 1));
      assertThrows(IllegalArgumentException.class, () -> biases.get("nothing"));
      assertThrows(IllegalArgumentException.class, () -> biases.apply("nothing"));
      assertTrue(biases.parameters().stream().allMatch(p -> !p.help().isEmpty()));
    }
  }

  @Test
  void slidersMoveBiasesAndAreResetByABiasSet() throws IOException {
    try (Camera camera = open()) {
      Biases biases = camera.facet(Biases.class).orElseThrow();
      BiasSliders sliders = camera.facet(BiasSliders.class).orElseThrow();
      for (Slider slider : Slider.values()) {
        assertEquals(0, sliders.get(slider));
        sliders.set(slider, 1);
        assertEquals(1, sliders.get(slider));
      }
      assertEquals(30_000, biases.get("bandwidthHz"), 1e-6);
      assertEquals(0.6, biases.get("threshold"), 1e-9);
      assertEquals(300, biases.get("refractoryUs"), 1e-9);
      sliders.set(Slider.BANDWIDTH, -1);
      assertEquals(300, biases.get("bandwidthHz"), 1e-6);
      assertThrows(IllegalArgumentException.class, () -> sliders.set(Slider.BALANCE, 1.1));
      biases.apply("slow");
      for (Slider slider : Slider.values()) {
        assertEquals(0, sliders.get(slider));
      }
      assertEquals(300, biases.get("bandwidthHz"));
    }
  }

  @Test
  void onlyEventsInTheRegionOfInterestAreDelivered() throws IOException {
    try (Camera camera = open()) {
      RegionOfInterest roi = camera.facet(RegionOfInterest.class).orElseThrow();
      roi.setRegion(Optional.of(new Region(40, 50, 30, 20)));
      pull(camera, stream, 100);
      EventPacket events = recorder.events();
      assertTrue(events.size() > 10);
      for (int i = 0; i < events.size(); i++) {
        assertTrue(events.x(i) >= 40 && events.x(i) < 70 && events.y(i) >= 50);
        assertTrue(events.y(i) < 70);
      }
      roi.setRegion(Optional.empty());
      pull(camera, stream, 100);
      assertTrue(recorder.events().size() > 3 * events.indexAtOrAfter(100_000, 0));
      assertThrows(
          IllegalArgumentException.class,
          () -> roi.setRegion(Optional.of(new Region(100, 0, 30, 20))));
    }
  }

  @Test
  void configurationIsTextForARecordingHeader() throws IOException {
    try (Camera camera = open()) {
      camera.facet(BiasSliders.class).orElseThrow().set(Slider.BALANCE, 0.5);
      camera
          .facet(RegionOfInterest.class)
          .orElseThrow()
          .setRegion(Optional.of(new Region(1, 2, 3, 4)));
      String text = camera.facet(Configuration.class).orElseThrow().text();
      List<String> lines = text.lines().toList();
      assertEquals("camera = simulated:fly", lines.get(0));
      assertEquals("region = 3x4 at 1,2 px", lines.get(1));
      assertTrue(lines.contains("bias.threshold = 0.2 ln"), text);
      assertTrue(lines.contains("bias.balance = 0.5 1"), text);
    }
  }

  @Test
  void clocksOfTwoCamerasAreRelatedByTheHostClock() throws IOException {
    try (Camera fly = open();
        Camera road = cameras.open("simulated:road", CameraOptions.DEFAULT)) {
      assertTrue(fly.clockRelation().isEmpty());
      pull(fly, stream, 20);
      pull(road, new StreamRecorder(), 20);
      ClockRelation flys = fly.clockRelation().orElseThrow();
      ClockRelation roads = road.clockRelation().orElseThrow();
      assertEquals(20_000, flys.onClockOf(roads, 20_000) + 20_000, 1000);
    }
  }

  @Test
  void sceneWithoutPixelModelHasNoBiases() throws IOException {
    try (Camera camera = cameras.open("simulated:dots", CameraOptions.DEFAULT)) {
      assertTrue(camera.facet(Biases.class).isEmpty());
      assertTrue(camera.facet(Configuration.class).isPresent());
      pull(camera, stream, 50);
      assertTrue(recorder.events().size() > 10);
      assertEquals("dots", new MovingDotsSceneProvider().name());
    }
  }
}
