package haltere.core.format.internal.evt;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.event.Trigger;
import haltere.core.format.RandomSamples;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFormat;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.WriteOptions;
import haltere.testing.EventPackets;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Edges on inputs among EVT words, with their direction and the number of the input. */
class EvtTriggersTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(640, 480, Origin.TOP);
  private static final long FIRST_US = 16_000_000;

  @TempDir Path folder;

  static Stream<RecordingFormat> formats() {
    return Stream.of(new Evt2Format(), new Evt21Format(), new Evt3Format());
  }

  @ParameterizedTest
  @MethodSource("formats")
  void edgesKeepTheirPositionsAmongEvents(RecordingFormat format) throws IOException {
    EventPacket events = EventPackets.uniform(SENSOR, 1, 50_000, FIRST_US, 100);
    SplittableRandom random = new SplittableRandom(2);
    RandomSamples samples = new RandomSamples(SENSOR, 3);
    List<Trigger> triggers = new ArrayList<>();
    Path file = folder.resolve("edges." + format.name());
    try (RecordingWriter writer = format.create(file, WriteOptions.of(SENSOR)).orElseThrow()) {
      int from = 0;
      for (long timeUs = FIRST_US - 50; from < events.size(); timeUs += random.nextInt(40_000)) {
        int to = events.indexAtOrAfter(timeUs);
        writer.write(EventPackets.part(events, from, to));
        from = to;
        Trigger trigger = samples.edge(timeUs, 16);
        triggers.add(trigger);
        assertTrue(writer.write(trigger));
      }
      assertEquals(List.of(), writer.losses());
      writer.finish();
    }

    StreamRecorder stream = new StreamRecorder();
    try (RecordingReader reader = format.open(file, ReadOptions.DEFAULT.withSamples(true))) {
      reader.drainTo(stream);
      assertEquals(events, stream.events());
      assertEquals(triggers, stream.samples(Trigger.class));
      for (StreamRecorder.Read read : stream.placedSamples()) {
        assertEquals(events.indexAtOrAfter(read.sample().timeUs()), read.eventsBefore());
      }
      assertEquals(triggers.size(), reader.countSamples().triggers());

      long seekUs = events.timeUs(40_000);
      reader.seek(seekUs);
      StreamRecorder part = new StreamRecorder();
      reader.drainTo(part);
      List<Trigger> later = triggers.stream().filter(one -> one.timeUs() >= seekUs).toList();
      assertEquals(later, part.samples(Trigger.class));
    }
  }

  @ParameterizedTest
  @MethodSource("formats")
  void samplesWithoutAnEncodingAreRejected(RecordingFormat format) throws IOException {
    Path file = folder.resolve("refused." + format.name());
    try (RecordingWriter writer = format.create(file, WriteOptions.of(SENSOR)).orElseThrow()) {
      assertFalse(writer.write(new Trigger(1, Trigger.Source.EXPOSURE, Trigger.Edge.RISING, 0)));
      assertFalse(
          writer.write(new Trigger(1, Trigger.Source.EXTERNAL_INPUT, Trigger.Edge.PULSE, 0)));
      assertFalse(
          writer.write(new Trigger(1, Trigger.Source.EXTERNAL_INPUT, Trigger.Edge.RISING, 32)));
      assertFalse(writer.write(new RandomSamples(SENSOR, 1).sample(1)));
      writer.finish();
    }
  }
}
