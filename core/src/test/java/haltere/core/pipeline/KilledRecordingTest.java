package haltere.core.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.format.Violation;
import haltere.core.format.internal.aedat4.Aedat4Compression;
import haltere.testing.StreamRecorder;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * A process that records is killed, fifty times, at whatever moment: while it writes the header, a
 * packet, the table, or between. Each time its files open and hold what it had handed over, but for
 * what waited in its memory.
 */
@Timeout(120)
class KilledRecordingTest {
  private static final int KILLS = Integer.getInteger("haltere.kills", 12);
  private static final int MAX_REPORTS = 150;

  /** Packets in the queue, the one that is not full, and the one that is being written. */
  private static final long MAX_MISSING =
      (RecordingProcess.QUEUE_PACKETS + 1L) * Recorder.PACKET_EVENTS + 3000;

  @TempDir Path folder;

  /** Last report of the process about a recording. */
  private record ReportedState(long recording, long events, boolean finished) {}

  @Test
  void aRecordingIsReadableWheneverItsProcessIsKilled() throws Exception {
    ExecutorService two = Executors.newFixedThreadPool(2);
    try {
      List<Future<Integer>> kills = new ArrayList<>();
      for (int kill = 0; kill < KILLS; kill++) {
        int seed = kill;
        kills.add(two.submit(() -> killAndRead(seed)));
      }
      int unfinished = 0;
      for (Future<Integer> kill : kills) {
        unfinished += kill.get();
      }
      assertTrue(unfinished > KILLS / 2, "only " + unfinished + " were cut short");
    } finally {
      two.shutdownNow();
    }
  }

  private int killAndRead(int seed) throws Exception {
    Path own = Files.createDirectory(folder.resolve("kill-" + seed));
    Random random = new Random(seed);
    Aedat4Compression[] packings = {Aedat4Compression.LZ4, Aedat4Compression.NONE};
    Process process =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:TieredStopAtLevel=1",
                "-XX:+UseSerialGC",
                "-Xshare:auto",
                "-Xmx64m",
                "-cp",
                System.getProperty("java.class.path"),
                RecordingProcess.class.getName(),
                own.toString(),
                Integer.toString(seed),
                packings[seed % 2].name())
            .redirectError(own.resolve("errors.txt").toFile())
            .start();
    List<ReportedState> reported;
    try (DataInputStream out = new DataInputStream(process.getInputStream())) {
      reported = listen(out, process, 1 + random.nextInt(MAX_REPORTS));
    } finally {
      process.destroyForcibly();
    }
    assertEquals("", Files.readString(own.resolve("errors.txt")));
    return check(own, reported);
  }

  /** Returns the last report of each recording; kills the process after some reports. */
  private static List<ReportedState> listen(DataInputStream out, Process process, int reports)
      throws Exception {
    List<ReportedState> last = new ArrayList<>();
    int left = reports;
    try {
      while (true) {
        ReportedState reported =
            new ReportedState(out.readLong(), out.readLong(), out.readLong() == 1);
        if (reported.recording() == last.size()) {
          last.add(reported);
        } else {
          last.set((int) reported.recording(), reported);
        }
        if (--left == 0) {
          // Not by Process, which would drop reports that are not read yet.
          process.toHandle().destroyForcibly();
          assertTrue(process.waitFor(20, TimeUnit.SECONDS));
        }
      }
    } catch (EOFException e) {
      assertTrue(left <= 0, "it ended by itself");
      return last;
    }
  }

  /** Returns how many recordings were cut short: none or one. */
  private static int check(Path folder, List<ReportedState> reported) throws IOException {
    for (ReportedState one : reported.subList(0, reported.size() - 1)) {
      assertTrue(one.finished());
    }
    int unfinished = 0;
    // It may have begun another without a word.
    for (int recording = 0; recording <= reported.size(); recording++) {
      Path file = RecordingProcess.file(folder, recording);
      ReportedState last =
          recording < reported.size()
              ? reported.get(recording)
              : new ReportedState(recording, 0, false);
      if (recording == reported.size() && !Files.exists(file)) {
        continue;
      }
      StreamRecorder read = new StreamRecorder();
      try (RecordingReader reader = Recordings.open(file)) {
        assertEquals(RecordingProcess.SENSOR.width(), reader.geometry().width());
        reader.drainTo(read);
        assertEquals(0, reader.violations().count(Violation.DAMAGED_PACKET), file.toString());
        if (last.finished()) {
          assertEquals(List.of(), reader.violations().describe());
        }
      }
      EventPacket events = read.events();
      EventPacket expected = new EventPacket(events.size());
      RecordingProcess.append(expected, recording, 0, events.size());
      assertEquals(expected, events, file + " is not what was sent");
      if (last.finished()) {
        assertEquals(last.events(), events.size());
      } else {
        unfinished++;
        long missing = last.events() - events.size();
        assertTrue(missing <= MAX_MISSING, file + ": " + missing + " events are missing");
      }
    }
    return Math.min(1, unfinished);
  }
}
