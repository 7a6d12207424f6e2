package haltere.core.pipeline;

import haltere.core.chain.FilterChain;
import haltere.core.chain.FilterTiming;
import haltere.core.event.SensorGeometry;
import haltere.core.format.SampleCounts;
import haltere.core.format.Violation;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/**
 * The report of a {@link RecordingJob}.
 *
 * @param recording the file, or the folder of its parts
 * @param format name of its format
 * @param sensor the sensor that its events were read for
 * @param bytes size of the recording
 * @param counters received, passed, dropped and lost events
 * @param samples counts of frames, inertial samples and triggers
 * @param violations violations of the recording, by kind, each at least 1
 * @param warnings warnings about the recording for users, one line each without its name
 * @param stages each stage of the chain in order
 * @param files the written files
 * @param elapsedS time of the job, in seconds
 * @since 0.1
 */
public record JobReport(
    Path recording,
    String format,
    SensorGeometry sensor,
    long bytes,
    PipelineCounters counters,
    SampleCounts samples,
    Map<Violation, Long> violations,
    List<String> warnings,
    List<Stage> stages,
    List<JobResults.ResultFile> files,
    double elapsedS) {
  /**
   * The statistics of a stage.
   *
   * @param name the stage
   * @param enabled whether it was enabled
   * @param timing events in and out, and its time
   */
  public record Stage(String name, boolean enabled, FilterTiming timing) {}

  /**
   * The statistics of the stages of a chain so far.
   *
   * @param chain any chain
   * @return its own stages, in order
   */
  public static List<Stage> stages(FilterChain chain) {
    return chain.stages().stream()
        .map(stage -> new Stage(stage.name(), stage.isEnabled(), stage.timing()))
        .toList();
  }

  /** Copies the lists. */
  public JobReport {
    violations = Map.copyOf(violations);
    warnings = List.copyOf(warnings);
    stages = List.copyOf(stages);
    files = List.copyOf(files);
  }
}
