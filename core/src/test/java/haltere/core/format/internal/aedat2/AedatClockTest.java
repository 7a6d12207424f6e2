package haltere.core.format.internal.aedat2;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.format.TimeSegment;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamGrammar;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The 32-bit clock of the file becomes 64-bit time. */
class AedatClockTest {
  private static final int MAX = Integer.MAX_VALUE;
  private static final int MIN = Integer.MIN_VALUE;
  private static final long WRAP_US = 1L << 32;

  @TempDir Path folder;

  private StreamRecorder read(int... times) throws IOException {
    try (RecordingReader reader = Recordings.open(file(times))) {
      StreamRecorder recorder = new StreamRecorder();
      reader.drainTo(new StreamGrammar(recorder));
      return recorder;
    }
  }

  private Path file(int... times) throws IOException {
    AedatFile bytes = AedatFile.version2();
    for (int time : times) {
      bytes.dvs128(time, 1, 1, true);
    }
    return bytes.in(folder, "clock.aedat");
  }

  private void assertTimes(StreamRecorder recorder, long... timesUs) {
    int size = recorder.events().size();
    assertArrayEquals(timesUs, Arrays.copyOf(recorder.events().timesUs(), size));
  }

  private static Reset restarted(long lastUs, long nextUs) {
    return new Reset(Reset.Cause.CLOCK_RESTARTED, lastUs, nextUs);
  }

  @Test
  void wrapFromPositiveToNegativeContinuesTheClock() throws IOException {
    StreamRecorder recorder = read(MAX - 5, MAX, MIN, MIN + 7);
    assertTimes(recorder, MAX - 5L, MAX, MAX + 1L, MAX + 8L);
    assertEquals(List.of(), recorder.notifications(Reset.class));
  }

  @Test
  void clockContinuesOverManyWraps() throws IOException {
    int turns = 5;
    int steps = 16;
    int[] times = new int[turns * steps];
    long[] expected = new long[times.length];
    for (int i = 0; i < times.length; i++) {
      expected[i] = i * (WRAP_US / steps);
      times[i] = (int) expected[i];
    }
    StreamRecorder recorder = read(times);
    assertTimes(recorder, expected);
    assertEquals(List.of(), recorder.notifications(Reset.class));
  }

  @Test
  void unsignedClockWrapsToZero() throws IOException {
    assertTimes(read(-2, -1, 0, 1), -2, -1, 0, 1);
  }

  @Test
  void timesBelowZeroAreLegal() throws IOException {
    StreamRecorder recorder = read(MIN, -5, -5, 3);
    assertTimes(recorder, MIN, -5, -5, 3);
    assertEquals(List.of(), recorder.notifications(Reset.class));
  }

  @Test
  void backwardJumpsWithoutAWrapAreRestartsWithBothTimes() throws IOException {
    StreamRecorder recorder = read(1_000_000_000, 1_000_000_005, 0, 10);
    assertTimes(recorder, 1_000_000_000, 1_000_000_005, 0, 10);
    assertEquals(List.of(restarted(1_000_000_005, 0)), recorder.notifications(Reset.class));
  }

  @Test
  void backwardJumpsOfMoreThanHalfTheRangeAreWraps() throws IOException {
    assertEquals(
        List.of(restarted(1L << 30, -1L << 30)),
        read(1 << 30, -1 << 30).notifications(Reset.class));
    StreamRecorder wrapped = read((1 << 30) + 1, -1 << 30);
    assertEquals(List.of(), wrapped.notifications(Reset.class));
    assertTimes(wrapped, (1L << 30) + 1, 3L << 30);
  }

  @Test
  void restartAfterAWrapResetsTheWrapCount() throws IOException {
    StreamRecorder recorder = read(MAX, MIN, -5, 2_000_000_000, 7, 8);
    assertTimes(recorder, MAX, MAX + 1L, WRAP_US - 5, WRAP_US + 2_000_000_000, 7, 8);
    assertEquals(
        List.of(restarted(WRAP_US + 2_000_000_000, 7)), recorder.notifications(Reset.class));
  }

  @Test
  void disorderedEventsAfterAWrapKeepTheWrapCount() throws IOException {
    StreamRecorder recorder = read(MAX, MIN + 100_000, MIN + 90_000);
    assertTimes(recorder, MAX, MAX + 100_001L, MAX + 90_001L);
    assertEquals(
        List.of(restarted(MAX + 100_001L, MAX + 90_001L)), recorder.notifications(Reset.class));
  }

  @Test
  void lateEventsFromBeforeAWrapCauseNoJump() throws IOException {
    StreamRecorder recorder = read(MAX, MIN, MAX - 3000, MIN + 1);
    assertTimes(recorder, MAX, MAX + 1L, MAX - 3000L, MAX + 2L);
    assertEquals(List.of(restarted(MAX + 1L, MAX - 3000L)), recorder.notifications(Reset.class));
  }

  @Test
  void eventsLateByAMillisecondDoNotRestartTheClockEvenAcrossAWrap() throws IOException {
    StreamRecorder recorder = read(MAX - 50, MIN + 100, MAX - 40, MIN + 90, MIN + 110);
    assertTimes(recorder, MAX - 50L, MAX + 101L, MAX + 101L, MAX + 101L, MAX + 111L);
    assertEquals(List.of(), recorder.notifications(Reset.class));
  }

  @Test
  void everyRestartStartsASeekableSegment() throws IOException {
    try (RecordingReader reader =
        Recordings.open(file(10_000, 20_000, 30_000, 5000, 15_000, 25_000, 5000))) {
      assertEquals(
          List.of(
              new TimeSegment(10_000, 30_000),
              new TimeSegment(5000, 25_000),
              new TimeSegment(5000, 5000)),
          reader.segments());
      reader.seek(1, 6000);
      StreamRecorder recorder = new StreamRecorder();
      reader.drainTo(recorder);
      assertTimes(recorder, 15_000, 25_000, 5000);
      assertEquals(List.of(restarted(25_000, 5000)), recorder.notifications(Reset.class));
    }
  }

  @Test
  void wrapsAndRestartsDoNotDependOnPacketBoundaries() throws IOException {
    int[] times = new int[10_000];
    int time = MAX - 40_000;
    for (int i = 0; i < times.length; i++) {
      times[i] = time += i % 3000 == 2999 ? -500_000_000 : 7;
    }
    Path file = file(times);
    StreamRecorder usual = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(file)) {
      reader.drainTo(new StreamGrammar(usual));
    }
    assertEquals(3, usual.notifications(Reset.class).size());
    for (int packetEvents : new int[] {1, 2, 1023, 1024, 1025, 4096}) {
      StreamRecorder recorder = new StreamRecorder();
      try (RecordingReader reader =
          Recordings.open(file, ReadOptions.DEFAULT.withPacketEvents(packetEvents))) {
        reader.drainTo(new StreamGrammar(recorder));
      }
      assertEquals(usual.events(), recorder.events());
      assertEquals(usual.notifications(), recorder.notifications());
    }
  }
}
