package haltere.device.simulated;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.camera.Biases;
import haltere.core.camera.Camera;
import haltere.core.camera.CameraOptions;
import haltere.core.camera.Cameras;
import haltere.core.camera.TimestampReset;
import haltere.core.event.EventPacket;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.core.format.internal.aedat4.Aedat4Compression;
import haltere.core.format.internal.aedat4.Aedat4Writer;
import haltere.core.pipeline.CameraHeader;
import haltere.core.pipeline.SessionRecorder;
import haltere.core.simulation.internal.fly.FlyScene;
import haltere.core.simulation.internal.fly.FlySceneSettings;
import haltere.testing.ManualClock;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Instant;
import java.time.ZoneId;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Recordings of cameras that are unplugged and reconnected, and the relation of their clocks. */
@Timeout(60)
class CameraSessionTest {
  private static final long MS = 1_000_000;
  private static final long BEGIN_S = 1_795_278_000;

  @TempDir Path folder;
  private final ManualClock time = new ManualClock();
  private final Cameras cameras =
      new Cameras(List.of(new SimulatedCameraProvider(time, () -> time)));

  /** Time of day that goes with the manual clock. */
  private final Clock day =
      new Clock() {
        @Override
        public Instant instant() {
          return Instant.ofEpochSecond(BEGIN_S).plusNanos(time.getAsLong());
        }

        @Override
        public ZoneId getZone() {
          return ZoneOffset.UTC;
        }

        @Override
        public Clock withZone(ZoneId zone) {
          return this;
        }
      };

  private Camera open(String id) throws IOException {
    return cameras.open(id, CameraOptions.DEFAULT.withReconnect(true));
  }

  private SessionRecorder session(Camera camera, String name, String chain) {
    return new SessionRecorder(
        folder.resolve(name),
        camera.geometry(),
        (file, metadata) ->
            Aedat4Writer.createInPlace(
                file,
                new WriteOptions(camera.geometry(), false, Optional.empty(), metadata),
                Aedat4Compression.LZ4),
        SessionRecorder.Limits.DEFAULT,
        new CameraHeader(camera, () -> Optional.of(chain), time, day),
        () -> Long.MAX_VALUE);
  }

  private void pull(Camera camera, SessionRecorder session, long ms) throws IOException {
    long until = time.getAsLong() + ms * MS;
    while (time.getAsLong() < until) {
      camera.next(session);
    }
  }

  private static EventPacket events(Path file) throws IOException {
    StreamRecorder recorder = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(file)) {
      reader.drainTo(recorder);
    }
    return recorder.events();
  }

  private static Map<String, String> metadata(Path file) throws IOException {
    try (RecordingReader reader = Recordings.open(file)) {
      return reader.metadata();
    }
  }

  @Test
  void unpluggingAndResetsSplitARecordingIntoPartsWithEachEventOnce() throws IOException {
    List<SessionRecorder.Part> parts;
    Camera camera = open("simulated:fly");
    try (SessionRecorder session = session(camera, "fly.aedat4", "{}")) {
      Plug plug = camera.facet(Plug.class).orElseThrow();
      pull(camera, session, 40);
      plug.unplug();
      while (camera.await(0)) {
        camera.next(session);
      }
      time.advance(5000 * MS);
      plug.plugIn();
      pull(camera, session, 40);
      camera.facet(TimestampReset.class).orElseThrow().resetTimestamps();
      pull(camera, session, 40);
      camera.close();
      while (camera.next(session)) {
        // to the end
      }
      parts = session.finish();
    }
    assertEquals(3, parts.size());
    List<Integer> addresses = new ArrayList<>();
    for (SessionRecorder.Part part : parts) {
      EventPacket events = events(part.file());
      assertTrue(events.lastTimeUs() < 45_000, "each part has its own clock");
      for (int i = 0; i < events.size(); i++) {
        addresses.add(events.address(i));
      }
    }
    StreamRecorder scene = new StreamRecorder();
    FlyScene fly = new FlyScene(FlySceneSettings.defaults());
    while (scene.events().size() < addresses.size()) {
      fly.next(scene);
    }
    for (int i = 0; i < addresses.size(); i++) {
      assertEquals(scene.events().address(i), addresses.get(i), "event " + i);
    }
    long first = Long.parseLong(metadata(parts.get(0).file()).get("clockOffsetUs"));
    long second = Long.parseLong(metadata(parts.get(1).file()).get("clockOffsetUs"));
    assertEquals(5_040_000, second - first, 2000);
  }

  @Test
  void headerContainsBiasesAndChain() throws IOException {
    try (Camera camera = open("simulated:fly");
        SessionRecorder session = session(camera, "fly.aedat4", "{\n  \"filters\" : [ ]\n}\n")) {
      camera.facet(Biases.class).orElseThrow().set("threshold", 0.25);
      pull(camera, session, 10);
    }
    Map<String, String> metadata = metadata(folder.resolve("fly.aedat4"));
    assertEquals("simulated:fly", metadata.get("camera"));
    assertEquals("0.25 ln", metadata.get("camera.bias.threshold"));
    assertEquals("{ \"filters\" : [ ] }", metadata.get("chain"));
  }

  @Test
  void clockOffsetsInTheHeadersRelateTwoCameras() throws IOException {
    try (Camera fly = open("simulated:fly");
        Camera road = open("simulated:road");
        SessionRecorder flySession = session(fly, "fly.aedat4", "{}");
        SessionRecorder roadSession = session(road, "road.aedat4", "{}")) {
      time.advance(777 * MS);
      pull(fly, flySession, 20);
      time.advance(123 * MS);
      pull(road, roadSession, 20);
    }
    long fly = Long.parseLong(metadata(folder.resolve("fly.aedat4")).get("clockOffsetUs"));
    long road = Long.parseLong(metadata(folder.resolve("road.aedat4")).get("clockOffsetUs"));
    assertEquals(BEGIN_S * 1_000_000 + 777_000, fly, 1000);
    assertEquals(143_000, road - fly, 1000);
  }
}
