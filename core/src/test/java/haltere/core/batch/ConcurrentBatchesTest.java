package haltere.core.batch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.FilterChain;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingProblem;
import haltere.core.pipeline.RecordingJob;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Batches that write to one folder at the same time. */
class ConcurrentBatchesTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(8, 8);

  @TempDir Path folder;

  /** Ignores progress, failures and warnings. */
  private static final class Silent implements Batch.Listener {
    @Override
    public void progress(long doneBytes, long totalBytes) {
      // not of interest
    }

    @Override
    public void failed(BatchFailure failure) {
      // in the report
    }

    @Override
    public void warned(BatchItem item, String warning) {
      // not of interest
    }
  }

  private List<BatchItem> recordings(int count) throws IOException {
    BatchItem[] items = new BatchItem[count];
    for (int i = 0; i < count; i++) {
      Path file = folder.resolve(i + ".csv");
      // the first is the largest, which is processed first
      Files.writeString(file, "t_us,x,y,on\n1,2,3,1\n" + "2,2,3,1\n".repeat(count - i));
      items[i] = new BatchItem(file, i + ".csv", Files.size(file));
    }
    return List.of(items);
  }

  private BatchReport run(
      List<BatchItem> items, BatchOptions.Existing existing, RecordingJob.ChainFactory chain)
      throws IOException {
    return run(folder.resolve("results"), items, existing, chain);
  }

  private static BatchReport run(
      Path results,
      List<BatchItem> items,
      BatchOptions.Existing existing,
      RecordingJob.ChainFactory chain)
      throws IOException {
    BatchOptions options =
        new BatchOptions(
            results,
            1,
            existing,
            ReadOptions.DEFAULT.withSensor(SENSOR),
            false,
            "test",
            "csv",
            Set.of());
    return new Batch(chain, options, Throwable::toString).run(items, "failed.json", new Silent());
  }

  /** Runs a second batch over the second recording while the first batch is at the first one. */
  private BatchReport runWithAnother(
      BatchOptions.Existing existing, RecordingJob.ChainFactory others) throws IOException {
    List<BatchItem> items = recordings(2);
    AtomicBoolean started = new AtomicBoolean();
    return run(
        items,
        existing,
        sensor -> {
          if (sensor.width() == SENSOR.width() && started.compareAndSet(false, true)) {
            BatchReport second = run(items.subList(1, 2), existing, others);
            assertEquals(1, second.done());
          }
          return new FilterChain(sensor);
        });
  }

  private static FilterChain anotherChain(SensorGeometry sensor) {
    FilterChain chain = new FilterChain(sensor);
    chain.add("nested", new FilterChain(sensor));
    return chain;
  }

  @Test
  void resultOfAnotherChainIsNotReplacedUnasked() throws IOException {
    BatchReport report =
        runWithAnother(BatchOptions.Existing.REFUSE, ConcurrentBatchesTest::anotherChain);
    assertEquals(1, report.done());
    assertEquals(1, report.failures().size());
    String cause = report.failures().get(0).cause();
    assertTrue(cause.contains("there is a result already"), cause);
    assertTrue(Files.exists(folder.resolve("results/1.csv/done.json")));
  }

  @ParameterizedTest
  @EnumSource(
      value = BatchOptions.Existing.class,
      names = {"REFUSE", "RESUME"})
  void resultOfAnotherBatchIsKept(BatchOptions.Existing existing) throws IOException {
    BatchReport report = runWithAnother(existing, FilterChain::new);
    assertEquals(1, report.done());
    assertEquals(1, report.kept());
    assertEquals(List.of(), report.failures());
  }

  @Test
  void eachRecordingIsProcessedOnceByManyBatches() throws Exception {
    List<BatchItem> items = recordings(200);
    ExecutorService threads = Executors.newFixedThreadPool(4);
    try {
      List<Future<BatchReport>> batches =
          threads.invokeAll(
              Collections.nCopies(
                  4, () -> run(items, BatchOptions.Existing.RESUME, FilterChain::new)));
      int done = 0;
      for (Future<BatchReport> batch : batches) {
        BatchReport report = batch.get();
        assertEquals(List.of(), report.failures());
        done += report.done();
      }
      assertEquals(items.size(), done);
    } finally {
      threads.shutdownNow();
    }
    try (var files = Files.walk(folder.resolve("results"))) {
      assertEquals(
          items.size(),
          files
              .filter(Files::isRegularFile)
              .peek(file -> assertEquals("done.json", file.getFileName().toString()))
              .count());
    }
  }

  @Test
  void failuresThatAnotherBatchIsWritingAreLeftAlone() throws IOException {
    Path results = Files.createDirectory(folder.resolve("results"));
    Path another = Files.writeString(results.resolve("failed.json.part"), "of another batch");
    Path damaged = Files.writeString(folder.resolve("damaged.aedat4"), "#!AER-DAT4.0\r\n");
    BatchItem item = new BatchItem(damaged, "damaged.aedat4", Files.size(damaged));
    BatchReport report = run(List.of(item), BatchOptions.Existing.REFUSE, FilterChain::new);
    assertEquals(1, report.failures().size());
    assertTrue(Files.readString(results.resolve("failed.json")).contains("damaged.aedat4"));
    assertEquals("of another batch", Files.readString(another));
  }

  @Test
  void failuresOfAnotherBatchAreKeptOnlyOfRecordingsThatItHadTaken() throws IOException {
    Path damaged = Files.writeString(folder.resolve("damaged.aedat4"), "#!AER-DAT4.0\r\n");
    List<BatchItem> items = new ArrayList<>(recordings(3));
    items.set(2, new BatchItem(damaged, "0-damaged", Files.size(damaged)));
    Path results = Files.createDirectory(folder.resolve("results"));
    Path failed = results.resolve("failed.json");
    Files.writeString(
        failed, "{\"failed\": [{\"recording\": \"0.csv\"}, {\"recording\": \"1.csv\"}]}");
    ResultFolder taken = ResultFolder.take(results.resolve("1.csv")).orElseThrow();
    BatchReport report = run(items, BatchOptions.Existing.REFUSE, FilterChain::new);
    taken.close();
    assertEquals(1, report.elsewhere());
    assertEquals(1, report.failures().size());
    String listed = Files.readString(failed);
    assertFalse(listed.contains("0.csv"), listed);
    assertTrue(listed.indexOf("0-damaged") > 0, listed);
    assertTrue(listed.indexOf("1.csv") > listed.indexOf("0-damaged"), "sorted by their names");
  }

  @Test
  @DisabledOnOs(OS.WINDOWS)
  void folderThatCannotBeWrittenToIsRefusedOnceAndNotForEachRecording() throws IOException {
    List<BatchItem> items = recordings(2);
    Path results = folder.resolve("missing/../results");
    RecordingProblem problem =
        assertThrows(
            RecordingProblem.class,
            () -> run(results, items, BatchOptions.Existing.REFUSE, FilterChain::new));
    assertTrue(problem.getMessage().contains("no results can be written there"));
  }

  @Test
  void interruptedBatchLeavesNoFiles() throws IOException {
    BatchReport report =
        run(
            recordings(1),
            BatchOptions.Existing.RESUME,
            sensor -> {
              if (sensor.width() == SENSOR.width()) {
                Thread.currentThread().interrupt();
              }
              return new FilterChain(sensor);
            });
    assertEquals(1, report.failures().size());
    assertFalse(Files.exists(folder.resolve("results/0.csv")));
  }
}
