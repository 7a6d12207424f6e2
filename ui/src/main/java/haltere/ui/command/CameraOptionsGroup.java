package haltere.ui.command;

import haltere.core.camera.Biases;
import haltere.core.camera.Camera;
import haltere.core.camera.CameraOptions;
import haltere.core.camera.CameraOptions.WhenFull;
import haltere.core.camera.CameraProblem;
import haltere.core.camera.Cameras;
import haltere.core.chain.FilterChain;
import haltere.core.pipeline.JobReport;
import haltere.core.pipeline.JobResults;
import haltere.core.pipeline.RecordingJob;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;

/** Options of commands that can read events from a camera. */
final class CameraOptionsGroup extends OptionGroup {
  /** Description of the recording that is read in place of a camera. */
  static final String FILE = "A recording, unless --device names a camera.";

  @Option(
      names = "--device",
      paramLabel = "ID",
      description = "A camera by its id in haltere devices; \"\" for the first connected one.")
  List<String> devices = List.of();

  @Option(
      names = "--duration",
      paramLabel = "S",
      description = "End after this many seconds; default: until Ctrl+C.")
  Double durationS;

  @Option(
      names = "--biases",
      paramLabel = "SET",
      description = "Apply a bias set of the camera, such as fast or slow.")
  String set;

  @Option(
      names = "--bias",
      paramLabel = "NAME=VALUE",
      description = "Set a bias of the camera. May be repeated.")
  Map<String, Double> biases = Map.of();

  @Option(
      names = "--when-full",
      paramLabel = "newest|oldest",
      description =
          "Events to drop if this computer is too slow: the newest (default), or those "
              + "that have waited longest (oldest).")
  Loss whenFull;

  /** Which events are lost. */
  enum Loss {
    NEWEST,
    OLDEST
  }

  /** Rejects wrong options before any work, by a {@link ParameterException}. */
  void check() {
    subcommand().checkDuration(durationS);
  }

  /**
   * Checks, and refuses both a recording and a camera or none, and options of a camera without one;
   * the file is null without a recording.
   */
  void checkOneSource(Path file) {
    check();
    if ((file == null) != given() || devices.size() > 1) {
      throw wrong("give either a FILE or one --device");
    }
    subcommand()
        .checkNeeded(given(), "--device", "--duration", "--biases", "--bias", "--when-full");
  }

  /** Whether a camera, or options of cameras, were given. */
  boolean given() {
    return !devices.isEmpty();
  }

  OptionalDouble durationS() {
    return durationS == null ? OptionalDouble.empty() : OptionalDouble.of(durationS);
  }

  /** Opens the results of a camera's events that go through a chain. */
  interface Results {
    JobResults open(Camera camera, FilterChain chain) throws IOException;
  }

  /**
   * Passes the camera's events, and samples on request, through a chain into results until its time
   * is over, it has ended or failed, or the process is to stop. Returns the report of each stage.
   */
  List<JobReport.Stage> run(boolean samples, RecordingJob.ChainFactory chains, Results results)
      throws IOException {
    try (Camera camera = open(devices.get(0), samples);
        FilterChain chain = chains.create(camera.geometry());
        JobResults opened = results.open(camera, chain)) {
      LiveRun run = new LiveRun(subcommand(), camera, chain, opened.sinks());
      LiveRun.run(List.of(run), durationS(), () -> false);
      run.summary();
      opened.finish();
      subcommand().wrote(opened.files());
      return JobReport.stages(chain);
    }
  }

  /**
   * Opens a camera, by its id or empty for the first one that is there, and sets its biases; on
   * request with frames, inertial samples and triggers.
   */
  Camera open(String device, boolean samples) throws CameraProblem {
    Camera camera =
        Cameras.installed()
            .open(
                device,
                CameraOptions.DEFAULT
                    .withReconnect(true)
                    .withSamples(samples)
                    .withWhenFull(
                        whenFull == Loss.OLDEST ? WhenFull.DROP_OLDEST : WhenFull.DROP_NEWEST));
    try {
      setBiases(camera);
      return camera;
    } catch (IllegalArgumentException wrong) {
      camera.close();
      throw new CommandProblem(camera.info().id() + ": " + wrong.getMessage());
    } catch (CameraProblem | RuntimeException problem) {
      camera.close();
      throw problem;
    }
  }

  private void setBiases(Camera camera) throws CameraProblem {
    if (set == null && biases.isEmpty()) {
      return;
    }
    Biases all =
        camera
            .facet(Biases.class)
            .orElseThrow(() -> new CommandProblem(camera.info().id() + " has no biases"));
    if (set != null) {
      all.apply(set);
    }
    for (Map.Entry<String, Double> bias : biases.entrySet()) {
      all.set(bias.getKey().strip(), bias.getValue());
    }
  }
}
