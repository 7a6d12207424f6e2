package haltere.ui.command;

import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingClock;
import haltere.core.format.RecordingOutline;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.summary.Gap;
import haltere.core.format.summary.RecordingSummary;
import haltere.core.json.internal.Json;
import haltere.core.stream.StreamNotification;
import haltere.ui.command.terminal.ProgressBar;
import haltere.ui.command.terminal.Quantities;
import haltere.ui.plot.EventRate;
import haltere.ui.rendering.ContactSheet;
import haltere.ui.rendering.Pictures;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Reads recordings through and says what is in them. */
@Command(
    name = "info",
    footer = {"", "Example: haltere info recording.aedat4 --picture recording.png"},
    description = "Say what is in recordings: format, sensor, events, times, rates, gaps.")
final class InfoCommand extends Subcommand {
  @Parameters(arity = "1..*", paramLabel = "FILE", description = "Recordings.")
  List<Path> files;

  @Option(
      names = "--json",
      description =
          "Write a JSON object, or for several files an array with an object for each; one that"
              + " cannot be read has only the keys file and error.")
  boolean json;

  @Option(
      names = "--quick",
      description =
          "Say only what a recording tells of itself (its sensor, events and times), without"
              + " reading its events; one that does not tell is read all the same.")
  boolean quick;

  @Option(
      names = "--picture",
      paramLabel = "FILE.png",
      description = "Write pictures of the recording at up to eight moments into one file.")
  Path picture;

  @Mixin ReadingOptions reading;
  @Mixin WritingOptions writing;

  @Override
  public Integer call() throws IOException {
    reading.readOptions();
    if (picture != null) {
      if (quick || files.size() > 1) {
        throw wrongArguments("--picture is of one recording that is read, so not with --quick");
      }
      writing.check(picture);
      WritingOptions.checkDifferent(files.get(0), picture);
    }
    if (files.size() == 1) {
      return single(files.get(0));
    }
    int status = OK;
    List<Object> objects = new ArrayList<>();
    for (Path file : files) {
      if (surroundings().out().checkError()) {
        return status; // nobody reads on
      }
      try {
        if (!describe(file, objects)) {
          status = FAILED;
        }
      } catch (IOException problem) {
        if (Failures.isInterruption(problem)) {
          throw problem;
        }
        if (isDebug()) {
          problem.printStackTrace(surroundings().err());
        }
        String line = Failures.describe(problem);
        error(line);
        objects.add(failed(file, line));
        status = FAILED;
      }
    }
    if (json) {
      result(Json.write(objects));
    }
    return status;
  }

  private int single(Path file) throws IOException {
    List<Object> objects = new ArrayList<>();
    boolean whole = describe(file, objects);
    if (json) {
      result(Json.write(objects.get(0)));
    }
    return whole ? OK : FAILED;
  }

  /** Describes a file; false if it is less whole than the user demands. */
  private boolean describe(Path file, List<Object> objects) throws IOException {
    RecordingSummary summary;
    RecordingClock clock;
    Map<String, String> metadata;
    Optional<RecordingProblem> objection;
    EventRate rates = new EventRate(48);
    try (RecordingReader reader = reading.open(file);
        ProgressBar bar = progressBar("reading", file)) {
      Optional<RecordingOutline> outline = quick ? reader.outline() : Optional.empty();
      if (outline.isPresent()) {
        describe(reader, outline.get(), objects);
        return true;
      }
      clock = reader.clock();
      metadata = reader.metadata();
      if (picture == null) {
        summary = RecordingSummary.scan(reader, bar, rates);
      } else {
        ContactSheet sheet = new ContactSheet(reader.geometry(), (timeUs, marks) -> {});
        summary = RecordingSummary.scan(reader, bar, rates, sheet);
        Pictures.write(picture, sheet.draw());
      }
      objection = reading.objection(file, reader.violations());
    }
    if (json) {
      Map<String, Object> object = object(summary);
      add(metadata, object);
      objection.ifPresent(problem -> object.put("error", problem.getMessage()));
      objects.add(object);
    } else {
      print(file, summary, clock);
      metadata.forEach(this::line);
      if (surroundings().outIsTerminal() && summary.events() > 0) {
        line("rate", rates.line() + "  up to " + Quantities.rate(rates.highestHz()));
      }
    }
    for (String warning : summary.warnings()) {
      warning(file + ": " + warning);
    }
    if (picture != null) {
      message("wrote " + picture);
    }
    objection.ifPresent(problem -> error(problem.getMessage()));
    return objection.isEmpty();
  }

  private void describe(RecordingReader reader, RecordingOutline outline, List<Object> objects) {
    double durationS = (outline.lastUs() - outline.firstUs()) / 1e6;
    double meanRateEps = durationS > 0 ? outline.events() / durationS : 0;
    if (json) {
      Map<String, Object> object = identity(reader.formatName(), reader.geometry());
      object.put("events", outline.events());
      object.put("firstUs", outline.firstUs());
      object.put("lastUs", outline.lastUs());
      object.put("durationS", durationS);
      object.put("meanRateEps", meanRateEps);
      object.put("warnings", reader.remarks());
      add(reader.metadata(), object);
      objects.add(object);
    } else {
      result(reader.path().toString());
      printIdentity(reader.formatName(), reader.geometry());
      line("events", Quantities.count(outline.events()));
      if (outline.events() > 0) {
        printTimes(outline.firstUs(), outline.lastUs(), durationS, meanRateEps);
        line("zero", reader.clock().describe());
      }
      reader.metadata().forEach(this::line);
    }
    for (String remark : reader.remarks()) {
      warning(reader.path() + ": " + remark);
    }
  }

  /** Stands for a file that cannot be read, so that the array has a place for each file. */
  private static Map<String, Object> failed(Path file, String line) {
    Map<String, Object> object = new LinkedHashMap<>();
    object.put("file", file.toString());
    object.put("error", line);
    return object;
  }

  private static Map<String, Object> identity(String format, SensorGeometry geometry) {
    Map<String, Object> object = new LinkedHashMap<>();
    object.put("format", format);
    object.put("width", geometry.width());
    object.put("height", geometry.height());
    object.put("origin", geometry.origin().name().toLowerCase(Locale.ROOT));
    return object;
  }

  private static Map<String, Object> object(RecordingSummary summary) {
    Map<String, Object> object = identity(summary.format(), summary.geometry());
    object.put("events", summary.events());
    object.put("on", summary.on());
    object.put("off", summary.off());
    object.put("firstUs", summary.firstUs());
    object.put("lastUs", summary.lastUs());
    object.put("durationS", summary.durationS());
    object.put("meanRateEps", summary.meanRateEps());
    object.put("peakRateEps", summary.peakRateEps());
    object.put("timestampsMonotonic", summary.timestampsMonotonic());
    List<Object> gaps = new ArrayList<>();
    for (Gap gap : summary.gaps()) {
      Map<String, Object> entry = new LinkedHashMap<>();
      entry.put("fromUs", time(gap.fromUs()));
      entry.put("toUs", time(gap.toUs()));
      entry.put("told", gap.told());
      gaps.add(entry);
    }
    object.put("gaps", gaps);
    object.put("warnings", summary.warnings());
    if (!summary.samples().isEmpty()) {
      object.put("frames", summary.samples().frames());
      object.put("inertialSamples", summary.samples().inertialSamples());
      object.put("triggers", summary.samples().triggers());
    }
    return object;
  }

  /** What the recording says of its camera and chain, if anything. */
  private static void add(Map<String, String> metadata, Map<String, Object> object) {
    if (!metadata.isEmpty()) {
      object.put("metadata", metadata);
    }
  }

  private static Object time(long timeUs) {
    return timeUs == StreamNotification.NO_TIME_US ? null : (Object) timeUs;
  }

  private void printIdentity(String format, SensorGeometry geometry) {
    line("format", format);
    line(
        "sensor",
        geometry
            + " pixels, rows count from the "
            + geometry.origin().name().toLowerCase(Locale.ROOT));
  }

  private void printTimes(long firstUs, long lastUs, double durationS, double meanRateEps) {
    line("time", Quantities.seconds(firstUs) + " to " + Quantities.seconds(lastUs));
    line("duration", Quantities.text("%.6f s", durationS));
    line("mean rate", Quantities.rate(meanRateEps));
  }

  private void print(Path file, RecordingSummary summary, RecordingClock clock) {
    result(file.toString());
    printIdentity(summary.format(), summary.geometry());
    line(
        "events",
        Quantities.text("%,d  (%,d ON, %,d OFF)", summary.events(), summary.on(), summary.off()));
    if (!summary.samples().isEmpty()) {
      line("also", summary.samples().toString());
    }
    if (summary.events() == 0) {
      return;
    }
    printTimes(summary.firstUs(), summary.lastUs(), summary.durationS(), summary.meanRateEps());
    line("peak rate", Quantities.rate(summary.peakRateEps()) + "  (over 10 ms)");
    line(
        "clock",
        summary.timestampsMonotonic()
            ? "never goes back"
            : "goes back: " + summary.segments().size() + " segments");
    line("zero", clock.describe());
    line("gaps", gaps(summary.gaps()));
  }

  private static String gaps(List<Gap> gaps) {
    if (gaps.isEmpty()) {
      return "none";
    }
    return gaps.size() + ", the longest " + longest(gaps);
  }

  private static String longest(List<Gap> gaps) {
    Gap longest = null;
    for (Gap gap : gaps) {
      boolean timed =
          gap.fromUs() != StreamNotification.NO_TIME_US
              && gap.toUs() != StreamNotification.NO_TIME_US;
      if (timed
          && (longest == null || gap.toUs() - gap.fromUs() > longest.toUs() - longest.fromUs())) {
        longest = gap;
      }
    }
    return longest == null
        ? "of unknown length"
        : Quantities.text(
            "%.3f s from %s",
            (longest.toUs() - longest.fromUs()) / 1e6, Quantities.seconds(longest.fromUs()));
  }

  private void line(String name, String value) {
    result("  %-10s  %s", name, value);
  }
}
