package com.example.imagej;

import haltere.core.event.EventPacket;
import haltere.core.event.Frame;
import haltere.core.event.SampleKind;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.core.simulation.Scene;
import haltere.core.simulation.Scenes;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;

/** Writes recordings for the tests: a fly whose wings beat at 200 Hz, and a camera with frames. */
public final class Simulations {
  private Simulations() {}

  public static void main(String[] folder) throws IOException {
    Path into = Files.createDirectories(Path.of(folder[0]));
    List<String> fly = List.of("run.durationS=2", "run.seed=1", "stroke.beat.frequencyHz=200");
    try (Scene<?> scene = Scenes.named("fly").create(fly);
        RecordingWriter writer = writer(into.resolve("fly.aedat"), scene.geometry())) {
      scene.drainTo(eventsTo(writer));
      writer.finish();
    }
    SensorGeometry sensor = new SensorGeometry(4, 3);
    try (RecordingWriter writer = writer(into.resolve("frames.aedat4"), sensor)) {
      for (int i = 0; i < 5; i++) {
        byte[] values = new byte[12];
        Arrays.fill(values, (byte) (10 * i));
        values[0] = (byte) 250; // upper left corner
        Frame.Times times = new Frame.Times(1000 * i, 1000 * i + 100);
        writer.write(new Frame(times, 0, 0, 4, 3, 1, Frame.Depth.UNSIGNED_8, values));
        EventPacket packet = new EventPacket(1);
        packet.append(1000 * i + 500, i % 4, 0, true);
        writer.write(packet);
      }
      writer.finish();
    }
  }

  private static RecordingWriter writer(Path file, SensorGeometry sensor) throws IOException {
    WriteOptions options =
        WriteOptions.of(sensor).withOverwrite(true).withSamples(Set.of(SampleKind.FRAME));
    return Recordings.forWriting(file).create(file, options).orElseThrow();
  }

  private static StreamHandler eventsTo(RecordingWriter writer) {
    return new StreamHandler() {
      @Override
      public void packet(EventPacket packet) {
        try {
          writer.write(packet);
        } catch (IOException problem) {
          throw new UncheckedIOException(problem);
        }
      }

      @Override
      public void notified(StreamNotification notification) {
        // a file has its own start and end
      }
    };
  }
}
