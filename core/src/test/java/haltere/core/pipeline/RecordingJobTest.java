package haltere.core.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.FilterChain;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** One recording through one chain. */
class RecordingJobTest {
  @TempDir Path folder;

  @Test
  void eventsAtImpossibleTimesAreReported() throws IOException {
    Path file =
        Files.writeString(
            folder.resolve("a.csv"), "t_us,x,y,on\n1,2,3,1\n9223372036854775807,2,3,1\n");
    JobReport report = RecordingJob.of(file, FilterChain::new, (reader, chain) -> () -> {}).run();
    assertEquals(1, report.counters().get(PipelineCounters.Counter.EVENTS_AT_IMPOSSIBLE_TIMES));
    String warnings = report.warnings().toString();
    assertTrue(
        warnings.contains("events at impossible times, left out by the filters: 1"), warnings);
  }
}
