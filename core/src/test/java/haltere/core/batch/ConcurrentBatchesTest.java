package haltere.core.batch;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.FilterChain;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.pipeline.RecordingJob;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

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
    BatchOptions options =
        new BatchOptions(
            folder.resolve("results"),
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
  private BatchReport runWithAnother(BatchOptions.Existing existing) throws IOException {
    List<BatchItem> items = recordings(2);
    AtomicBoolean started = new AtomicBoolean();
    return run(
        items,
        existing,
        sensor -> {
          if (sensor.width() == SENSOR.width() && started.compareAndSet(false, true)) {
            BatchReport second = run(items.subList(1, 2), existing, FilterChain::new);
            assertEquals(1, second.done());
          }
          return new FilterChain(sensor);
        });
  }

  @Test
  void resultOfAnotherBatchIsNotReplacedUnasked() throws IOException {
    BatchReport report = runWithAnother(BatchOptions.Existing.REFUSE);
    assertEquals(1, report.done());
    assertEquals(1, report.failures().size());
    String cause = report.failures().get(0).cause();
    assertTrue(cause.contains("there is a result already"), cause);
    assertTrue(Files.exists(folder.resolve("results/1.csv/done.json")));
  }

  @Test
  void resultOfAnotherBatchIsKept() throws IOException {
    BatchReport report = runWithAnother(BatchOptions.Existing.RESUME);
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
