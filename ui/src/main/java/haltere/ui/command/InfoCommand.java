package haltere.ui.command;

import haltere.core.chain.FilterChain;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingClock;
import haltere.core.format.RecordingOutline;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.summary.EventRate;
import haltere.core.format.summary.Gap;
import haltere.core.format.summary.RecordingSummary;
import haltere.core.json.internal.Json;
import haltere.core.settings.Parameter;
import haltere.core.stream.StreamNotification;
import haltere.ui.command.terminal.ProgressBar;
import haltere.ui.command.terminal.Quantities;
import haltere.ui.rendering.ContactSheet;
import haltere.ui.rendering.Pictures;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Reads recordings and describes them. */
@Command(
    name = "info",
    footer = {"", "Example: haltere info recording.aedat4 --picture recording.png"},
    description = "Describe recordings: format, sensor, events, times, rates, gaps.")
final class InfoCommand extends Subcommand {
  @Parameters(arity = "1..*", paramLabel = "FILE", description = "Recordings.")
  List<Path> files;

  @Option(
      names = "--json",
      description =
          "Write a JSON object, or an array of objects for several files. For an "
              + "unreadable file, the object has only the keys file and error.")
  boolean json;

  @Option(
      names = "--quick",
      description =
          "Show only the metadata of a recording (sensor, number of events, times) "
              + "without reading its events. A recording without such metadata is read.")
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
        throw wrongArguments("--picture needs one recording, and excludes --quick");
      }
      if (Pictures.problem(picture).isPresent()) {
        throw wrongArguments(Pictures.problem(picture).get());
      }
      writing.check(files, List.of(picture));
    }
    int status = OK;
    List<Object> objects = new ArrayList<>();
    for (Path file : files) {
      if (surroundings().out().checkError()) {
        return status; // the reader has closed the pipe
      }
      try {
        status = describe(file, objects) ? status : FAILED;
      } catch (IOException problem) {
        if (files.size() == 1 || Failures.isInterruption(problem)) {
          throw problem;
        }
        if (isDebug()) {
          problem.printStackTrace(surroundings().err());
        }
        String line = Failures.describe(problem);
        error(line);
        Map<String, Object> failed = new LinkedHashMap<>();
        failed.put("file", file.toString());
        failed.put("error", line);
        objects.add(failed);
        status = FAILED;
      }
    }
    if (json) {
      result(Json.write(files.size() == 1 ? objects.get(0) : objects));
    }
    return status;
  }

  /**
   * Facts of a recording.
   *
   * @param clock origin of its times
   * @param metadata properties of camera and chain, if stated
   * @param outline events and times
   * @param durationS length without intervals between segments of the clock, seconds
   * @param read results of a complete reading; empty with metadata only
   */
  private record Facts(
      RecordingClock clock,
      Map<String, String> metadata,
      RecordingOutline outline,
      double durationS,
      Optional<RecordingSummary> read) {
    double meanRateEps() {
      return durationS > 0 ? outline.events() / durationS : 0;
    }
  }

  /** Describes a file; false if it is less whole than the user demands. */
  private boolean describe(Path file, List<Object> objects) throws IOException {
    EventRate rates = new EventRate(48);
    try (RecordingReader reader = reading.open(file)) {
      Facts facts = facts(reader, rates);
      List<String> warnings = facts.read.map(RecordingSummary::warnings).orElse(reader.remarks());
      Optional<RecordingProblem> objection =
          facts.read.flatMap(all -> reading.objection(file, reader.violations()));
      if (json) {
        Map<String, Object> object = object(reader, facts, warnings);
        objection.ifPresent(problem -> object.put("error", problem.getMessage()));
        objects.add(object);
      } else {
        print(reader, facts);
        if (surroundings().outIsTerminal() && rates.maxHz() > 0) {
          line("rate", rates.line() + "  up to " + Quantities.rate(rates.maxHz()));
        }
      }
      warnings(file, warnings);
      if (picture != null) {
        boolean any = facts.outline().events() > 0;
        message(any ? "wrote " + picture : "no picture: there are no events");
      }
      objection.ifPresent(problem -> error(problem.getMessage()));
      return objection.isEmpty();
    }
  }

  private Facts facts(RecordingReader reader, EventRate rates) throws IOException {
    RecordingClock clock = reader.clock();
    Map<String, String> metadata = reader.metadata();
    Optional<RecordingOutline> outline = quick ? reader.outline() : Optional.empty();
    if (outline.isPresent()) {
      double durationS = (outline.get().lastUs() - outline.get().firstUs()) / 1e6;
      return new Facts(clock, metadata, outline.get(), durationS, Optional.empty());
    }
    try (ProgressBar bar = progressBar("reading", reader.path())) {
      ContactSheet sheet = new ContactSheet(new FilterChain(reader.geometry()));
      RecordingSummary read =
          picture == null
              ? RecordingSummary.scan(reader, bar, rates)
              : RecordingSummary.scan(reader, bar, rates, sheet);
      if (picture != null && read.events() > 0) {
        Pictures.write(picture, sheet.draw().orElseThrow());
      }
      RecordingOutline found = new RecordingOutline(read.events(), read.firstUs(), read.lastUs());
      return new Facts(clock, metadata, found, read.durationS(), Optional.of(read));
    }
  }

  private static Map<String, Object> object(
      RecordingReader reader, Facts facts, List<String> warnings) {
    SensorGeometry geometry = reader.geometry();
    Map<String, Object> object = new LinkedHashMap<>();
    object.put("format", reader.formatName());
    object.put("width", geometry.width());
    object.put("height", geometry.height());
    object.put("origin", Parameter.text(geometry.origin()));
    object.put("events", facts.outline.events());
    facts.read.ifPresent(
        read -> {
          object.put("on", read.on());
          object.put("off", read.off());
        });
    object.put("firstUs", facts.outline.firstUs());
    object.put("lastUs", facts.outline.lastUs());
    object.put("durationS", facts.durationS);
    object.put("meanRateEps", facts.meanRateEps());
    facts.read.ifPresent(
        read -> {
          object.put("peakRateEps", read.peakRateEps());
          object.put("timestampsMonotonic", read.timestampsMonotonic());
          object.put("gaps", read.gaps().stream().map(InfoCommand::object).toList());
        });
    object.put("warnings", warnings);
    facts
        .read
        .map(RecordingSummary::samples)
        .filter(samples -> !samples.isEmpty())
        .ifPresent(
            samples -> {
              object.put("frames", samples.frames());
              object.put("inertialSamples", samples.inertialSamples());
              object.put("triggers", samples.triggers());
            });
    if (!facts.metadata.isEmpty()) {
      object.put("metadata", facts.metadata);
    }
    return object;
  }

  private static Map<String, Object> object(Gap gap) {
    Map<String, Object> object = new LinkedHashMap<>();
    object.put("fromUs", time(gap.fromUs()));
    object.put("toUs", time(gap.toUs()));
    object.put("told", gap.reported());
    return object;
  }

  private static Object time(long timeUs) {
    return timeUs == StreamNotification.NO_TIME_US ? null : (Object) timeUs;
  }

  private void print(RecordingReader reader, Facts facts) {
    SensorGeometry geometry = reader.geometry();
    RecordingOutline outline = facts.outline;
    result(reader.path().toString());
    line("format", reader.formatName());
    line("sensor", geometry + " pixels, rows count from the " + Parameter.text(geometry.origin()));
    String events = Quantities.count(outline.events());
    line(
        "events",
        facts
            .read
            .map(read -> Quantities.text("%s  (%,d ON, %,d OFF)", events, read.on(), read.off()))
            .orElse(events));
    facts
        .read
        .filter(read -> !read.samples().isEmpty())
        .ifPresent(read -> line("also", read.samples().toString()));
    if (outline.events() > 0) {
      String last = Quantities.seconds(outline.lastUs());
      line("time", Quantities.seconds(outline.firstUs()) + " to " + last);
      line("duration", Quantities.text("%.6f s", facts.durationS));
      line("mean rate", Quantities.rate(facts.meanRateEps()));
      facts.read.ifPresent(
          read -> {
            line("peak rate", Quantities.rate(read.peakRateEps()) + "  (over 10 ms)");
            line("clock", read.clockInWords());
          });
      line("zero", facts.clock.describe());
      facts.read.ifPresent(read -> line("gaps", gaps(read.gaps())));
    }
    facts.metadata.forEach(this::line);
  }

  private static String gaps(List<Gap> gaps) {
    if (gaps.isEmpty()) {
      return "none";
    }
    return gaps.stream()
        .filter(gap -> time(gap.fromUs()) != null && time(gap.toUs()) != null)
        .min(Comparator.comparingLong(gap -> gap.fromUs() - gap.toUs()))
        .map(
            gap ->
                Quantities.text(
                    "%d, the longest %.3f s from %s",
                    gaps.size(),
                    (gap.toUs() - gap.fromUs()) / 1e6,
                    Quantities.seconds(gap.fromUs())))
        .orElse(gaps.size() + ", the longest of unknown length");
  }

  private void line(String name, String value) {
    result("  %-10s  %s", name, value);
  }
}
