package haltere.core.pipeline;

import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.event.SensorSample;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.format.SampleCounts;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.pipeline.PipelineCounters.Counter;
import haltere.core.stream.EventSource;
import haltere.core.stream.SharedWork;
import haltere.core.stream.StreamHandler;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.UnaryOperator;

/**
 * One recording through one chain into files: the step that commands, a batch and a cluster share.
 * The same job on the same recording writes the same bytes wherever it runs.
 *
 * <p>Thread rule: immutable. {@link #run} works on the calling thread, except for shared work of
 * filters with {@link #onThreads two threads}. A job may run several times, also concurrently if
 * its results have different paths.
 *
 * @since 0.1
 */
public final class RecordingJob {
  /** Opens the recording of a job. */
  public interface Opening {
    /**
     * Opens a recording.
     *
     * @param recording the job's
     * @param options the job's
     * @return a reader at its start, closed by the job
     * @throws IOException if it cannot be read
     */
    RecordingReader open(Path recording, ReadOptions options) throws IOException;
  }

  /** Creates the chain of a job. */
  public interface ChainFactory {
    /**
     * Creates a chain.
     *
     * @param geometry the sensor of the recording
     * @return a chain of new filters, closed by the job
     * @throws IOException if the chain cannot be read
     */
    FilterChain create(SensorGeometry geometry) throws IOException;
  }

  /** Opens the results of a job. */
  public interface ResultsFactory {
    /**
     * Opens results.
     *
     * @param reader the recording, of which nothing has been read
     * @param chain the job's chain
     * @return finished and closed by the job
     * @throws IOException if a file cannot be written
     */
    JobResults open(RecordingReader reader, FilterChain chain) throws IOException;
  }

  /** Receives the progress of a job. */
  public interface Progress {
    /**
     * Receives the progress; called often, so it must be cheap.
     *
     * @param events events that went into the chain
     * @param doneBytes bytes of the recording read so far
     * @param totalBytes bytes of the recording
     */
    void progress(long events, long doneBytes, long totalBytes);
  }

  private final Path recording;
  private final ChainFactory chain;
  private final ResultsFactory results;
  private final ReadOptions options;
  private final Opening opening;
  private final boolean strict;
  private final UnaryOperator<EventSource> pace;
  private final Progress progress;
  private final int threads;

  private RecordingJob(
      Path recording,
      ChainFactory chain,
      ResultsFactory results,
      ReadOptions options,
      Opening opening,
      boolean strict,
      UnaryOperator<EventSource> pace,
      Progress progress,
      int threads) {
    this.recording = Objects.requireNonNull(recording, "recording");
    this.chain = Objects.requireNonNull(chain, "chain");
    this.results = Objects.requireNonNull(results, "results");
    this.options = Objects.requireNonNull(options, "options");
    this.opening = Objects.requireNonNull(opening, "opening");
    this.strict = strict;
    this.pace = Objects.requireNonNull(pace, "pace");
    this.progress = Objects.requireNonNull(progress, "progress");
    this.threads = threads;
  }

  /**
   * A job that uses the properties stated in the file and its undamaged part, at full speed.
   *
   * @param recording a file, or the folder of its parts
   * @param chain creates the chain
   * @param results opens the outputs
   * @return a job
   */
  public static RecordingJob of(Path recording, ChainFactory chain, ResultsFactory results) {
    return new RecordingJob(
        recording,
        chain,
        results,
        ReadOptions.DEFAULT,
        Recordings::open,
        false,
        UnaryOperator.identity(),
        (events, done, total) -> {},
        1);
  }

  /**
   * The same job on a recording that is read in another way.
   *
   * @param with options of the user for the recording
   * @param whole whether a recording that is cut off or damaged is an error
   * @return another job
   */
  public RecordingJob withReading(ReadOptions with, boolean whole) {
    return new RecordingJob(
        recording, chain, results, with, opening, whole, pace, progress, threads);
  }

  /**
   * The same job on a recording that is opened in another way, such as from standard input.
   *
   * @param by opens it
   * @return another job
   */
  public RecordingJob withOpening(Opening by) {
    return new RecordingJob(
        recording, chain, results, options, by, strict, pace, progress, threads);
  }

  /**
   * The same job with a stage between recording and chain.
   *
   * @param by wraps the stream of the recording, such as to pace it
   * @return another job
   */
  public RecordingJob withPacing(UnaryOperator<EventSource> by) {
    UnaryOperator<EventSource> both = source -> by.apply(pace.apply(source));
    return new RecordingJob(
        recording, chain, results, options, opening, strict, both, progress, threads);
  }

  /**
   * The same job with more results.
   *
   * @param more opened after those that the job has, and finished after them
   * @return another job
   */
  public RecordingJob withResults(ResultsFactory more) {
    ResultsFactory both =
        (reader, filters) ->
            JobResults.all(() -> results.open(reader, filters), () -> more.open(reader, filters));
    return new RecordingJob(
        recording, chain, both, options, opening, strict, pace, progress, threads);
  }

  /**
   * The same job with a listener of its progress.
   *
   * @param listener called on the thread of the job
   * @return another job
   */
  public RecordingJob withProgress(Progress listener) {
    return new RecordingJob(
        recording, chain, results, options, opening, strict, pace, listener, threads);
  }

  /**
   * The same job with filters that share their work with a second thread, for a long recording on
   * an idle computer. The results are the same, byte by byte.
   *
   * @param count 1 or 2; the default is 1
   * @return another job
   */
  public RecordingJob onThreads(int count) {
    return new RecordingJob(
        recording, chain, results, options, opening, strict, pace, progress, count);
  }

  /**
   * Runs the whole recording through the chain and writes the results.
   *
   * @return the report
   * @throws RecordingProblem if it cannot be read, or is damaged and has to be whole
   * @throws IOException if reading or writing fails, or {@link java.io.InterruptedIOException} if
   *     the thread is interrupted
   * @throws haltere.core.chain.FilterFailure if a filter throws. In all these cases no result
   *     appears
   */
  public JobReport run() throws IOException {
    long startNanos = System.nanoTime();
    try (RecordingReader reader = opening.open(recording, options);
        SharedWork work = new SharedWork(threads);
        FilterChain filters = chain.create(reader.geometry());
        JobResults written = results.open(reader, filters)) {
      filters.share(work);
      if (options.keepIndex()) {
        reader.segments();
      }
      PipelineCounters counters = new PipelineCounters();
      JobSink watch = new JobSink(reader, counters);
      ChainRunner runner = new ChainRunner(filters, counters, OnFailure.STOP, failure -> {});
      written.rawSinks().forEach(sink -> runner.addSink(sink, true));
      written.sinks().forEach(sink -> runner.addSink(sink, false));
      runner.addSink(watch, false);
      pace.apply(reader).drainTo(runner);
      requireComplete(reader, strict);
      written.finish();
      // A chain filters events: missing samples matter only in a recording without events.
      boolean hasEvents = counters.get(Counter.EVENTS_IN) > 0;
      List<String> warnings = new ArrayList<>(reader.remarks());
      warnings.addAll(
          reader.violations().describe(hasEvents ? Set.of(Violation.OTHER_DATA) : Set.of()));
      long impossible = counters.get(Counter.EVENTS_AT_IMPOSSIBLE_TIMES);
      if (impossible > 0) {
        warnings.add("events at impossible times, left out by the filters: " + impossible);
      }
      return new JobReport(
          recording,
          reader.formatName(),
          filters.geometry(),
          reader.sizeBytes(),
          counters,
          watch.samples,
          counts(reader.violations()),
          warnings,
          JobReport.stages(filters),
          written.files(),
          (System.nanoTime() - startNanos) / 1e9);
    }
  }

  /**
   * Refuses a recording that is not whole.
   *
   * @param reader at the end of the recording
   * @param whole whether it has to be whole
   * @throws RecordingProblem if it is cut off or damaged and has to be whole
   */
  public static void requireComplete(RecordingReader reader, boolean whole)
      throws RecordingProblem {
    Optional<RecordingProblem> damage = damage(reader.path(), reader.violations());
    if (whole && damage.isPresent()) {
      throw damage.get();
    }
  }

  /**
   * Why a recording is not whole: it is cut off or damaged. A clock that went back is no damage.
   *
   * @param recording its file
   * @param violations what its reader counted
   * @return the first damage, or empty if the recording is whole
   */
  public static Optional<RecordingProblem> damage(Path recording, ViolationCounts violations) {
    for (Violation kind : Violation.values()) {
      if (kind.isDamage() && violations.count(kind) > 0) {
        return Optional.of(
            new RecordingProblem(
                recording,
                violations.firstOffset(kind),
                kind.description() + "; leave out --strict to use what is whole"));
      }
    }
    return Optional.empty();
  }

  private static Map<Violation, Long> counts(ViolationCounts violations) {
    Map<Violation, Long> counts = new EnumMap<>(Violation.class);
    for (Violation kind : Violation.values()) {
      if (violations.count(kind) > 0) {
        counts.put(kind, violations.count(kind));
      }
    }
    return counts;
  }

  /** A sink that counts samples and reports the progress. */
  private final class JobSink implements StreamHandler {
    private final RecordingReader reader;
    private final PipelineCounters counters;
    private SampleCounts samples = SampleCounts.NONE;

    JobSink(RecordingReader reader, PipelineCounters counters) {
      this.reader = reader;
      this.counters = counters;
    }

    @Override
    public void packet(EventPacket packet) {
      progress.progress(
          counters.get(Counter.EVENTS_IN), reader.positionBytes(), reader.sizeBytes());
    }

    @Override
    public void sample(SensorSample sample) {
      samples = samples.plus(sample.kind());
    }
  }
}
