package haltere.ui.command;

import haltere.core.camera.Camera;
import haltere.core.chain.FilterProvider;
import haltere.core.pipeline.JobReport;
import haltere.core.pipeline.JobResults;
import haltere.core.pipeline.RecordingJob;
import haltere.core.pipeline.internal.Provenance;
import haltere.core.settings.SettingsProblem;
import haltere.core.settings.SettingsSchema;
import haltere.core.sink.Tables;
import haltere.ui.command.terminal.LiveStatus;
import haltere.ui.command.terminal.ProgressBar;
import haltere.ui.command.terminal.Quantities;
import haltere.ui.command.terminal.StandardOutput;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Function;
import java.util.stream.Stream;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.Spec;

/**
 * Common part of all commands: last options, output of results and messages, report of wrong
 * arguments.
 *
 * <p>Thread rule: made, run and thrown away on one thread.
 */
abstract class Subcommand implements Callable<Integer> {
  /** The status of success. */
  static final int OK = 0;

  /** The status of bad input or work that failed. */
  static final int FAILED = 1;

  /** The status of wrong arguments. */
  static final int WRONG_ARGUMENTS = 2;

  @Spec CommandSpec spec;

  @Option(
      names = ExtensionFolder.OPTION,
      order = 999,
      paramLabel = "FOLDER",
      description =
          "Folder of jars with more filters, formats and scenes; default: "
              + "$HALTERE_EXTENSIONS, or the folder extensions beside the settings.")
  Path extensions;

  @Option(
      names = "--quiet",
      order = 1000,
      description = "Hide the progress bar and messages; warnings and errors remain.")
  boolean quiet;

  @Option(names = "--debug", order = 1001, description = "Print the stack trace of an error.")
  boolean debug;

  @Option(
      names = {"-h", "--help"},
      order = 1002,
      usageHelp = true,
      description = "Print this help.")
  boolean help;

  private CommandEnvironment surroundings;
  private volatile boolean hasFailure;

  /** Sets the environment before the command runs. */
  Subcommand in(CommandEnvironment where) {
    surroundings = where;
    return this;
  }

  /** Whether the user requests stack traces, before or after the command's name. */
  boolean isDebug() {
    return debug || (parent() != null && parent().debug);
  }

  private boolean isQuiet() {
    return quiet || (parent() != null && parent().quiet);
  }

  private Subcommand parent() {
    return spec.parent() != null && spec.parent().userObject() instanceof Subcommand program
        ? program
        : null;
  }

  CommandEnvironment surroundings() {
    return surroundings;
  }

  /** Prints a line of the result: literal without values, else formatted. */
  void result(String form, Object... values) {
    surroundings.out().print(line(form, values));
  }

  private static String line(String form, Object... values) {
    return Failures.printable(values.length == 0 ? form : Quantities.text(form, values)) + "\n";
  }

  /** The standard output for bytes; fails where a print stream would ignore it. */
  OutputStream standardOutput() {
    return new FilterOutputStream(surroundings.out()) {
      @Override
      public void write(byte[] bytes, int offset, int length) throws IOException {
        surroundings.out().write(bytes, offset, length);
        check();
      }

      @Override
      public void flush() throws IOException {
        check();
      }

      private void check() throws IOException {
        if (surroundings.out().checkError()) {
          throw new StandardOutput.Gone();
        }
      }
    };
  }

  void message(String form, Object... values) {
    if (!isQuiet()) {
      surroundings.err().print(line(form, values));
    }
  }

  void warning(String form, Object... values) {
    surroundings.err().print("haltere: warning: " + line(form, values));
  }

  /** Prints warnings about a file, a line each. */
  void warnings(Path file, Iterable<String> lines) {
    lines.forEach(line -> warning(file + ": " + line));
  }

  void error(String line) {
    surroundings.err().print("haltere: " + line(line));
  }

  /** Reports a failure that does not end the command, but its status is {@link #FAILED} then. */
  void reportFailure(String line) {
    hasFailure = true;
    error(line);
  }

  /** The status of a successful command, with failures beside its work. */
  int statusWithFailures(int status) {
    return status == OK && hasFailure ? FAILED : status;
  }

  ProgressBar progressBar(String label) {
    String name = Failures.printable(label);
    return new ProgressBar(surroundings.err(), isLineShown(), name, System::nanoTime);
  }

  LiveStatus liveStatus(List<Camera> cameras) {
    return new LiveStatus(surroundings.err(), isLineShown(), cameras, System::nanoTime);
  }

  private boolean isLineShown() {
    return surroundings.errIsTerminal() && !isQuiet();
  }

  ProgressBar progressBar(String verb, Path file) {
    return progressBar(verb + " " + file.getFileName());
  }

  /** Runs a job with a progress bar, and prints outputs and warnings. */
  JobReport run(RecordingJob job, String verb, Path file) throws IOException {
    JobReport report;
    try (ProgressBar bar = progressBar(verb, file)) {
      report =
          job.onThreads(Math.min(2, Runtime.getRuntime().availableProcessors()))
              .withProgress(
                  (events, done, total) -> {
                    bar.events(events);
                    bar.progress(done, total);
                  })
              .run();
    }
    wrote(report.files());
    warnings(file, report.warnings());
    return report;
  }

  /** Rejects given options that have no effect without something else, such as another option. */
  void checkNeeded(boolean there, String needed, String... options) {
    ParseResult parsed = spec.commandLine().getParseResult();
    List<String> given = Stream.of(options).filter(parsed::hasMatchedOption).toList();
    if (!there && !given.isEmpty()) {
      String need = given.size() == 1 ? " needs " : " need ";
      throw wrongArguments(String.join(" and ", given) + need + needed);
    }
  }

  /** Rejects an unknown format of tables. */
  void checkTables(String option, String extension) {
    Optional<String> missing = Tables.problem(Path.of("table." + extension));
    if (missing.isPresent()) {
      throw wrongArguments(option + " is " + extension + ": " + missing.get());
    }
    if (!Tables.extensions().contains(extension)) {
      throw wrongArguments(
          option + " is " + extension + "; there is " + String.join(", ", Tables.extensions()));
    }
  }

  /** Metadata of tables, in addition to their chain or settings. */
  static Provenance provenance(Path source) {
    return new Provenance(new Version().getVersion()[0], Optional.ofNullable(source));
  }

  /** Says that a table was written. */
  void wrote(Path file, long rows) {
    message("wrote %s (%s)", file, Quantities.counted(rows, "row"));
  }

  /** Ends the work if the process is to stop. */
  static void checkInterrupted(String doing) throws InterruptedIOException {
    if (Thread.currentThread().isInterrupted()) {
      throw new InterruptedIOException("interrupted while " + doing);
    }
  }

  /** Says which tables were written. */
  void wrote(List<JobResults.ResultFile> files) {
    files.forEach(file -> wrote(file.path(), file.rows()));
  }

  /** Opens the viewer and waits until it is closed. */
  void openWindow(Function<WindowOpener, Optional<String>> opening) {
    WindowOpener window = surroundings.window();
    Optional<String> obstacle = window.obstacle().or(() -> opening.apply(window));
    if (obstacle.isPresent()) {
      throw new CommandProblem(obstacle.get());
    }
  }

  /** Settings of a filter under a name. */
  <S extends Record> S preset(FilterProvider<S> provider, String name) {
    S found = provider.presets().get(name);
    if (found == null) {
      String known = String.join(", ", provider.presets().keySet());
      throw wrongArguments("there is no preset " + name + "; there is: " + known);
    }
    return found;
  }

  /** Settings with options, by the settings' names, and assignments, which may not contradict. */
  <S extends Record> S assigned(
      Class<S> type, S settings, Map<String, Object> options, List<String> assignments) {
    List<String> own =
        options.entrySet().stream()
            .filter(option -> option.getValue() != null)
            .map(option -> option.getKey() + "=" + option.getValue())
            .toList();
    SettingsSchema<S> schema = SettingsSchema.of(type);
    try {
      S all = schema.withAssignments(schema.withAssignments(settings, own), assignments);
      for (String option : own) {
        if (!schema.withAssignments(all, List.of(option)).equals(all)) {
          throw wrongArguments("--set contradicts another option, which sets " + option);
        }
      }
      return all;
    } catch (SettingsProblem problem) {
      throw wrongArguments(problem.getMessage());
    }
  }

  /** Rejects a value of an option that is out of its range. */
  void checkRange(boolean isInRange, String option, Object value, String range) {
    if (!isInRange) {
      throw wrongArguments(option + " is " + value + ", it must be " + range);
    }
  }

  /** Rejects a duration in seconds that is out of range; null is none. */
  void checkDuration(Double s) {
    checkRange(s == null || s > 0 && s <= 1e9, "--duration", s, "above 0 and at most 1e9 s");
  }

  ParameterException wrongArguments(String message) {
    return new ParameterException(spec.commandLine(), message);
  }
}
