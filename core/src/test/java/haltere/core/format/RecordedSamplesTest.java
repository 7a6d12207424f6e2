package haltere.core.format;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.Frame;
import haltere.core.event.InertialSample;
import haltere.core.event.SensorSample;
import haltere.core.event.Trigger;
import haltere.core.stream.StreamGrammar;
import haltere.testing.EventPackets;
import haltere.testing.Recorded;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Frames, inertial samples and triggers of real recordings, as dv-processing and aedat see them.
 */
class RecordedSamplesTest {
  private static final ReadOptions WITH_SAMPLES = ReadOptions.DEFAULT.withSamples(true);
  private static final String DAVIS346 = "davis346-events-frames-imu.aedat4";
  private static final String DAVIS240 = "davis240c-rotating-disk-imu-aps.aedat";
  private static final String DVXPLORER = "dvxplorer-sample.aedat4";

  private static StreamRecorder read(String name, ReadOptions options) throws IOException {
    StreamRecorder recorder = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(Recorded.file(name), options)) {
      reader.drainTo(new StreamGrammar(recorder));
      assertEquals(0, reader.violations().count(Violation.INCOMPLETE_SAMPLE));
    }
    return recorder;
  }

  @Test
  void davisFramesAreTheSameAsInOtherPrograms() throws IOException {
    List<Frame> frames = read(DAVIS346, WITH_SAMPLES).samples(Frame.class);
    assertEquals(59, frames.size());
    Frame first = frames.get(0);
    assertEquals(
        new Frame.Times(1589163147364965L, 1589163147365465L, 1589163147355806L, 1589163147374647L),
        first.times());
    assertEquals("346x260x1 UNSIGNED_8 frame at 1589163147364965 us", first.toString());
    assertEquals(0, first.left() + first.bottom());
    int[] topLeft = {78, 75, 79, 69, 84};
    for (int x = 0; x < topLeft.length; x++) {
      assertEquals(topLeft[x], first.value(x, 259, 0));
    }
    int[] bottomRight = {13, 12, 13};
    for (int x = 0; x < bottomRight.length; x++) {
      assertEquals(bottomRight[x], first.value(343 + x, 0, 0));
    }
    Frame last = frames.get(58);
    assertEquals(1589163149684966L, last.timeUs());
    long sum = 0;
    for (int i = 0; i < last.rows().limit(); i++) {
      sum += last.rows().get(i) & 0xff;
    }
    assertEquals(6_940_332, sum);
  }

  @Test
  void davisInertialSamplesAreTheSameAsInOtherPrograms() throws IOException {
    List<InertialSample> samples = read(DAVIS346, WITH_SAMPLES).samples(InertialSample.class);
    assertEquals(2363, samples.size());
    assertEquals(
        new InertialSample(
            1589163147369190L,
            0.027587890625f,
            -0.9951171875f,
            0.259033203125f,
            0.7781981825828552f,
            -0.518798828125f,
            -0.015258788131177425f,
            28.51789665222168f,
            0,
            0,
            0),
        samples.get(0));
    assertEquals(1589163149728420L, samples.get(2362).timeUs());
    assertEquals(0.0457763634622097f, samples.get(2362).rotationZDegS());
    assertEquals(475, read(DVXPLORER, WITH_SAMPLES).samples(InertialSample.class).size());
  }

  @Test
  void triggersOfADavisMatchItsFrameTimes() throws IOException {
    List<Trigger> triggers = read(DAVIS346, WITH_SAMPLES).samples(Trigger.class);
    assertEquals(236, triggers.size());
    assertEquals(
        new Trigger(1589163147374647L, Trigger.Source.FRAME_READOUT, Trigger.Edge.FALLING, 0),
        triggers.get(0));
    assertEquals(
        new Trigger(1589163147395806L, Trigger.Source.FRAME_READOUT, Trigger.Edge.RISING, 0),
        triggers.get(1));
    assertEquals(
        new Trigger(1589163147404965L, Trigger.Source.EXPOSURE, Trigger.Edge.RISING, 0),
        triggers.get(2));
  }

  @Test
  void inertialSamplesOfAedat2HaveTheRangeOfTheHeader() throws IOException {
    StreamRecorder stream = read(DAVIS240, WITH_SAMPLES);
    List<InertialSample> samples = stream.samples(InertialSample.class);
    assertEquals(51_688 / 7, samples.size());
    assertEquals(samples.size(), stream.placedSamples().size());
    InertialSample first = samples.get(0);
    assertEquals(342_081, first.timeUs());
    float[] g = {first.accelerationXG(), first.accelerationYG(), first.accelerationZG()};
    assertArrayEquals(new float[] {948 / 4096f, -4042 / 4096f, 426 / 4096f}, g);
    assertEquals(1, Math.sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]), 0.03, "gravity");
    assertEquals(1040 * (1000 / 32768f), first.rotationZDegS());
    assertEquals(35 - 1184 / 340f, first.temperatureC());
    assertTrue(Float.isNaN(first.magneticXMicrotesla()));
  }

  @Test
  void frameOfARecordingWithoutEventsIsRead() throws IOException {
    StreamRecorder stream = read("gray16-frame.aedat4", WITH_SAMPLES);
    Frame frame = stream.samples(Frame.class).get(0);
    assertEquals("2x2x1 UNSIGNED_16 frame at 950 us", frame.toString());
    assertEquals(new Frame.Times(950, 1050, 900, 1100), frame.times());
    assertEquals(1, frame.value(0, 1, 0));
    assertEquals(2, frame.value(1, 1, 0));
    assertEquals(3, frame.value(0, 0, 0));
    assertEquals(1023, frame.value(1, 0, 0));
  }

  @ParameterizedTest
  @ValueSource(strings = {DAVIS346, DAVIS240, DVXPLORER})
  void samplesAreOrderedAmongEventsByTime(String name) throws IOException {
    StreamRecorder with = read(name, WITH_SAMPLES);
    EventPacket events = read(name, ReadOptions.DEFAULT).events();
    assertEquals(events, with.events());
    long lastUs = Long.MIN_VALUE;
    for (StreamRecorder.Read read : with.placedSamples()) {
      long timeUs = read.sample().timeUs();
      assertEquals(events.indexAtOrAfter(timeUs), read.eventsBefore(), "at " + timeUs + " us");
      assertTrue(timeUs >= lastUs, "at " + timeUs + " us");
      lastUs = timeUs;
    }
  }

  static Stream<String> counted() {
    return Stream.of(
        DAVIS346 + ": 59 frames, 2363 inertial samples, 236 triggers",
        DAVIS240 + ": 7384 inertial samples",
        DVXPLORER + ": 475 inertial samples",
        "gray16-frame.aedat4: 1 frame",
        "imx636-evt3.raw: none",
        "dvs128-pendulum.aedat: none");
  }

  @ParameterizedTest
  @MethodSource("counted")
  void samplesAreCountedEvenIfNotRequested(String line) throws IOException {
    String[] parts = line.split(": ");
    try (RecordingReader reader = Recordings.open(Recorded.file(parts[0]))) {
      assertEquals(parts[1], reader.countSamples().toString());
      assertEquals(0, reader.violations().describe().size());
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {DAVIS346, DAVIS240})
  void seekYieldsTheSamplesFromTheGivenTime(String name) throws IOException {
    StreamRecorder all = read(name, WITH_SAMPLES);
    try (RecordingReader reader = Recordings.open(Recorded.file(name), WITH_SAMPLES)) {
      for (int share = 0; share < 10; share++) {
        EventPacket events = all.events();
        long fromUs = events.timeUs(events.size() / 10 * share) + share % 2;
        reader.seek(fromUs);
        StreamRecorder part = new StreamRecorder();
        reader.drainTo(part);
        int from = events.indexAtOrAfter(fromUs);
        assertEquals(EventPackets.part(events, from, events.size()), part.events());
        List<SensorSample> expected =
            all.placedSamples().stream()
                .map(StreamRecorder.Read::sample)
                .filter(sample -> sample.timeUs() >= fromUs)
                .toList();
        assertEquals(
            expected,
            part.placedSamples().stream().map(StreamRecorder.Read::sample).toList(),
            "from " + fromUs + " us");
      }
    }
  }
}
