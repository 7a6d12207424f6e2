package haltere.core.batch;

import haltere.core.chain.FilterChain;
import haltere.core.format.AtomicFile;
import haltere.core.format.RecordingProblem;
import haltere.core.json.internal.Json;
import haltere.core.pipeline.JobReport;
import haltere.core.pipeline.JobResults;
import haltere.core.pipeline.OutletTables;
import haltere.core.pipeline.PipelineCounters.Counter;
import haltere.core.pipeline.RecordingJob;
import haltere.core.pipeline.ResultFiles;
import haltere.core.pipeline.internal.Provenance;
import haltere.core.stream.internal.Daemon;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;

/**
 * The same chain over many recordings. Each recording has a folder of its name below the folder of
 * the results, with a table for each outlet, {@code STAGE.OUTLET.csv} (or another format), and
 * {@code done.json}, which comes last. A failed recording does not stop the batch; {@code
 * failed.json} lists the failures. The results do not depend on the number of workers or shards,
 * nor on how often a run was killed.
 *
 * <p>Thread rule: {@link #run} waits for its workers; listeners are called on theirs, one at a
 * time.
 *
 * @since 0.1
 */
public final class Batch {
  /** Receives the progress of a batch. */
  public interface Listener {
    /**
     * Receives the progress; called often.
     *
     * @param doneBytes bytes of recordings worked on so far
     * @param totalBytes bytes of all recordings
     */
    void progress(long doneBytes, long totalBytes);

    /**
     * Receives a failed recording.
     *
     * @param failure the recording and the reason
     */
    void failed(BatchFailure failure);

    /**
     * Receives a warning about a recording.
     *
     * @param item the recording
     * @param warning one line
     */
    void warned(BatchItem item, String warning);
  }

  private final RecordingJob.ChainFactory chain;
  private final BatchOptions options;
  private final Function<Throwable, String> words;
  private final ResultRecord results;

  /**
   * A batch that has not started.
   *
   * @param chain creates the chain of each recording
   * @param options how to run
   * @param words turns an exception of a job into a line for users
   * @throws IOException if the chain cannot be made
   */
  public Batch(
      RecordingJob.ChainFactory chain, BatchOptions options, Function<Throwable, String> words)
      throws IOException {
    this.chain = Objects.requireNonNull(chain, "chain");
    this.options = Objects.requireNonNull(options, "options");
    this.words = Objects.requireNonNull(words, "words");
    results = new ResultRecord(chain, options);
  }

  /**
   * Processes recordings, the largest first.
   *
   * @param items recordings of different names
   * @param failed name of the file of failures, below the folder of the results; one of an earlier
   *     run is replaced, or removed if nothing failed; of another run at the same time, the
   *     failures of recordings that this run left to it are kept
   * @param listener receives the progress
   * @return the report
   * @throws RecordingProblem if a result exists before the run and none may, or if the folder of
   *     the results cannot be written to
   * @throws InterruptedIOException if the thread was interrupted; results that are complete stay
   * @throws IOException if the file of failures cannot be written
   */
  public BatchReport run(Collection<BatchItem> items, String failed, Listener listener)
      throws IOException {
    if (options.existing() == BatchOptions.Existing.REFUSE) {
      for (BatchItem item : items) {
        requireNoResult(folder(item), ResultFolder.done(folder(item)));
      }
    }
    Files.createDirectories(options.folder());
    if (!Files.isWritable(options.folder())) {
      throw new RecordingProblem(
          options.folder(), "no results can be written there; choose another folder");
    }
    Run run = new Run(items, listener);
    run.await();
    BatchReport report = run.report();
    Path file = options.folder().resolve(failed);
    writeFailures(report.failures(), failuresElsewhere(file, run.elsewhere), file);
    return report;
  }

  private static void requireNoResult(Path folder, Optional<?> done) throws RecordingProblem {
    if (done.isPresent()) {
      throw new RecordingProblem(
          folder,
          "there is a result already; give --resume to keep it, or --overwrite to replace it");
    }
  }

  private Path folder(BatchItem item) {
    return options.folder().resolve(item.name());
  }

  /** Failures that another run has listed of recordings that it had taken during this run. */
  private List<Map<?, ?>> failuresElsewhere(Path file, Set<String> elsewhere) {
    List<Map<?, ?>> failures = new ArrayList<>();
    try {
      if (Json.read(file) instanceof Map<?, ?> listed
          && listed.get("failed") instanceof List<?> entries) {
        for (Object entry : entries) {
          if (entry instanceof Map<?, ?> failure
              && failure.get("recording") instanceof String name
              && elsewhere.contains(name)
              && ResultFolder.done(options.folder().resolve(name)).isEmpty()) {
            failures.add(failure);
          }
        }
      }
    } catch (IOException ignored) {
      // no other run has failed
    }
    return failures;
  }

  private static void writeFailures(
      List<BatchFailure> failures, List<Map<?, ?>> elsewhere, Path file) throws IOException {
    if (failures.isEmpty() && elsewhere.isEmpty()) {
      Files.deleteIfExists(file);
      return;
    }
    List<Map<?, ?>> entries = new ArrayList<>(elsewhere);
    for (BatchFailure failure : failures) {
      Map<String, Object> entry = new LinkedHashMap<>();
      entry.put("recording", failure.item().name());
      entry.put("file", failure.item().recording().toString());
      entry.put("kind", failure.kind().toString());
      entry.put("cause", failure.cause());
      entries.add(entry);
    }
    entries.sort(Comparator.comparing(entry -> (String) entry.get("recording")));
    AtomicFile.write(file, Json.write(Map.of("failed", entries)) + "\n", true);
  }

  /** One run over the recordings. */
  private final class Run {
    private final Queue<BatchItem> waiting = new ConcurrentLinkedQueue<>();
    private final Listener listener;
    private final long totalBytes;
    private final List<BatchFailure> failures = new ArrayList<>();
    private long doneBytes;
    private int done;
    private int kept;
    private final Set<String> elsewhere = new HashSet<>();
    private long events;
    private long bytes;
    private long rows;
    private volatile boolean stopped;

    /**
     * Waits for the disk while workers go on; a worker whose result finds all threads at work waits
     * itself, so that the results in work are at most two for each worker.
     */
    private final ThreadPoolExecutor disk =
        new ThreadPoolExecutor(
            0,
            options.workers(),
            1,
            TimeUnit.SECONDS,
            new SynchronousQueue<>(),
            task -> Daemon.thread(task, "haltere-batch-disk"),
            new ThreadPoolExecutor.CallerRunsPolicy());

    Run(Collection<BatchItem> items, Listener listener) {
      this.listener = listener;
      totalBytes = items.stream().mapToLong(BatchItem::bytes).sum();
      items.stream()
          .sorted(
              Comparator.comparingLong(BatchItem::bytes).reversed().thenComparing(BatchItem::name))
          .forEach(waiting::add);
    }

    void await() throws InterruptedIOException {
      List<Thread> workers = new ArrayList<>();
      for (int i = 0; i < options.workers(); i++) {
        Thread worker = Daemon.thread(this::work, "haltere-batch-" + (i + 1));
        worker.start();
        workers.add(worker);
      }
      boolean interrupted = false;
      while (!disk.isTerminated()) {
        try {
          for (Thread worker : workers) {
            worker.join();
          }
          disk.shutdown();
          disk.awaitTermination(Long.MAX_VALUE, TimeUnit.NANOSECONDS);
        } catch (InterruptedException ignored) {
          interrupted = true;
          stopped = true;
          workers.forEach(Thread::interrupt);
        }
      }
      if (interrupted) {
        throw new InterruptedIOException("interrupted; complete results stay");
      }
    }

    private void work() {
      for (BatchItem next = waiting.poll(); next != null && !stopped; next = waiting.poll()) {
        BatchItem item = next;
        attempt(item, () -> work(item));
      }
    }

    private void attempt(BatchItem item, ResultFiles.Finish step) {
      try {
        step.run();
      } catch (Exception | Error thrown) {
        if (!stopped) {
          fail(new BatchFailure(item, BatchFailure.FailureKind.of(thrown), words.apply(thrown)));
        }
      }
    }

    private void work(BatchItem item) throws IOException {
      Path path = folder(item);
      RecordingProgress progress = new RecordingProgress(item.bytes());
      Optional<Map<?, ?>> earlier = ResultFolder.done(path);
      if (options.existing() != BatchOptions.Existing.OVERWRITE
          && results.isValid(item, path, earlier)) {
        progress.finish();
        update(() -> kept++);
        return;
      }
      if (options.existing() == BatchOptions.Existing.REFUSE) {
        requireNoResult(path, earlier);
      }
      Optional<ResultFolder> taken = ResultFolder.take(path);
      if (taken.isEmpty()) {
        progress.finish();
        update(() -> elsewhere.add(item.name()));
        return;
      }
      ResultFolder folder = taken.get();
      if (!ResultFolder.done(path).equals(earlier)) {
        // another batch has completed it meanwhile
        folder.release();
        work(item);
        return;
      }
      try {
        folder.clear();
        Provenance provenance = new Provenance(options.program(), Optional.of(item.recording()));
        JobReport report =
            RecordingJob.of(
                    item.recording(),
                    chain,
                    (reader, filters) -> open(folder, filters, provenance.chain(filters)))
                .withReading(options.reading(), options.strict())
                .withProgress((count, position, size) -> progress.reached(position))
                .run();
        String recordingSha256 = provenance.recordingSha256().orElseThrow();
        disk.execute(() -> attempt(item, () -> place(item, folder, report, recordingSha256)));
      } catch (Exception | Error thrown) {
        folder.close();
        throw thrown;
      }
      progress.finish();
    }

    private void place(
        BatchItem item, ResultFolder folder, JobReport report, String recordingSha256)
        throws IOException {
      try (folder) {
        folder.place(report.files());
        folder.complete(results.of(item, report, recordingSha256, folder(item)));
      }
      count(item, report);
    }

    private JobResults open(ResultFolder folder, FilterChain filters, Provenance provenance)
        throws IOException {
      OutletTables.Naming naming = options.naming(folder::path);
      folder.begin(OutletTables.files(filters, naming));
      return OutletTables.open(filters, naming, AtomicFile::staged, provenance);
    }

    private void count(BatchItem item, JobReport report) {
      update(
          () -> {
            done++;
            events += report.counters().get(Counter.EVENTS_IN);
            bytes += item.bytes();
            rows += report.files().stream().mapToLong(JobResults.ResultFile::rows).sum();
            report.warnings().forEach(warning -> listener.warned(item, warning));
          });
    }

    private void fail(BatchFailure failure) {
      update(
          () -> {
            failures.add(failure);
            listener.failed(failure);
          });
    }

    private synchronized void update(Runnable change) {
      change.run();
    }

    synchronized BatchReport report() {
      failures.sort(Comparator.comparing(failure -> failure.item().name()));
      return new BatchReport(done, kept, elsewhere.size(), failures, events, bytes, rows);
    }

    /** Bytes of one recording. */
    private final class RecordingProgress {
      private final long size;
      private long reached;

      RecordingProgress(long size) {
        this.size = size;
      }

      void reached(long position) {
        long now = Math.min(size, Math.max(reached, position));
        long more = now - reached;
        reached = now;
        update(
            () -> {
              doneBytes += more;
              listener.progress(doneBytes, totalBytes);
            });
      }

      void finish() {
        reached(size);
      }
    }
  }
}
