package haltere.ui.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.Filters;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class BenchCommandTest {
  @TempDir Path folder;

  @Test
  void everyStageIsListedWithItsThroughput() throws IOException {
    Path recording = TinyRecording.hundred().write(folder.resolve("hundred.aedat"));
    CommandRun run = CommandRun.of("bench", "--seconds", "0", recording);
    assertEquals(0, run.status(), run.err());
    assertTrue(run.err().contains("each stage warms up for 0.0 s, then the median"), run.err());
    List<String> lines = run.out().lines().toList();
    assertEquals(recording + ": 100 events, sensor 128x128", lines.get(0));
    List<String> stages = new ArrayList<>(List.of("decode aedat2"));
    stages.addAll(Filters.all().keySet());
    stages.add("default chain");
    assertEquals(stages.size() + 2, lines.size(), run.out());
    for (int i = 0; i < stages.size(); i++) {
      String line = lines.get(i + 2);
      assertTrue(line.startsWith(stages.get(i) + " "), line);
      String[] figures = line.substring(24).trim().split(" +");
      if (line.contains(" no work ")) {
        continue;
      }
      double nanos = Double.parseDouble(figures[1]);
      assertEquals(1e3 / nanos, Double.parseDouble(figures[0]), 0.05 + 5 / (nanos * nanos), line);
    }
  }

  @Test
  void recordingWithoutEventsIsRejected() throws IOException {
    Path none = new TinyRecording().write(folder.resolve("none.aedat"));
    CommandRun run = CommandRun.of("bench", none);
    assertEquals(1, run.status());
    assertEquals(1, run.errorLines().size(), run.err());
  }

  @Test
  void invalidDurationIsAWrongArgument() throws IOException {
    assertEquals(2, CommandRun.of("bench", "--seconds", "-1").status());
    assertEquals(2, CommandRun.of("bench", "--seconds", "NaN").status());
    assertTrue(Files.isDirectory(folder));
  }
}
