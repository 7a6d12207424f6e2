package haltere.core.batch;

import haltere.core.chain.ChainFile;
import haltere.core.chain.ChainProblem;
import haltere.core.chain.FilterChain;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.json.JsonProblem;
import haltere.core.json.internal.Json;
import haltere.core.pipeline.JobReport;
import haltere.core.pipeline.JobResults;
import haltere.core.pipeline.OutletTables;
import haltere.core.pipeline.PipelineCounters.Counter;
import haltere.core.pipeline.RecordingJob;
import haltere.core.pipeline.internal.Checksums;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/**
 * Record of a result, for its validation: it is valid while chain, program, options of reading and
 * the bytes of the recording are the same.
 *
 * <p>Thread rule: immutable.
 */
final class ResultRecord {
  /** Any sensor: settings do not depend on it. */
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);

  private final Map<String, Object> settings = new LinkedHashMap<>();

  /**
   * The part that all results of a batch share.
   *
   * @throws IOException if the chain cannot be created
   */
  ResultRecord(RecordingJob.ChainFactory factory, BatchOptions options) throws IOException {
    try (FilterChain chain = factory.create(SENSOR)) {
      List<Path> files = OutletTables.files(chain, options.naming(Path::of));
      if (files.stream().distinct().count() < files.size()) {
        throw new ChainProblem("two stages of the same name would write one table: " + files);
      }
      requireOutlets(chain, options.outlets());
      settings.put("chain", json(ChainFile.write(chain)));
    }
    settings.put("program", options.program());
    settings.put("reading", reading(options));
    settings.put("tables", options.tables());
    if (!options.outlets().isEmpty()) {
      settings.put("outlets", options.outlets().stream().sorted().toList());
    }
  }

  private static void requireOutlets(FilterChain chain, Set<String> named) throws ChainProblem {
    Set<String> outlets = new TreeSet<>();
    OutletTables.files(
        chain,
        (stage, outlet) -> {
          outlets.add(outlet.name());
          return Path.of(outlet.name());
        });
    for (String name : named) {
      if (!outlets.contains(name)) {
        throw new ChainProblem(
            "the chain has no outlet \"" + name + "\"; it has " + String.join(", ", outlets));
      }
    }
  }

  private static Object json(String chain) throws JsonProblem {
    return Json.parse(chain, "the chain");
  }

  private static Map<String, Object> reading(BatchOptions options) {
    ReadOptions given = options.reading();
    Map<String, Object> reading = new LinkedHashMap<>();
    given.sensor().ifPresent(sensor -> reading.put("sensor", sensor.toString()));
    given.format().ifPresent(format -> reading.put("format", format));
    given.topic().ifPresent(topic -> reading.put("topic", topic));
    given.origin().ifPresent(origin -> reading.put("origin", origin.toString()));
    reading.put("strict", options.strict());
    return reading;
  }

  /** Key of a valid result of a recording. */
  private String key(String recordingSha256) {
    Map<String, Object> all = new LinkedHashMap<>(settings);
    all.put("recording", recordingSha256);
    return Checksums.ofText(Json.write(all));
  }

  /**
   * Whether a result is valid. The recording is read if its size or modification time differ from
   * those of the result.
   */
  boolean isValid(BatchItem item, Path folder, Optional<Map<?, ?>> done) throws IOException {
    if (done.isEmpty()) {
      return false;
    }
    Map<?, ?> there = done.get();
    boolean same =
        Long.valueOf(item.bytes()).equals(there.get("recordingBytes"))
            && changed(item).equals(there.get("recordingChanged"))
            && there.get("recordingSha256") instanceof String;
    String sha256 = same ? (String) there.get("recordingSha256") : Checksums.of(item.recording());
    return key(sha256).equals(there.get("key")) && ResultFolder.isWhole(folder, there);
  }

  private static String changed(BatchItem item) throws IOException {
    return Files.getLastModifiedTime(item.recording()).toInstant().toString();
  }

  /** Content of the record of a complete result, independent of time and machine. */
  Map<String, Object> of(BatchItem item, JobReport report, String recordingSha256, Path folder)
      throws IOException {
    Map<String, Object> done = new LinkedHashMap<>();
    done.put("recording", item.name());
    done.put("recordingBytes", item.bytes());
    done.put("recordingChanged", changed(item));
    done.put("recordingSha256", recordingSha256);
    done.put("key", key(recordingSha256));
    done.putAll(settings);
    done.put("format", report.format());
    done.put("sensor", report.sensor().toString());
    Map<String, Object> counters = new LinkedHashMap<>();
    for (Counter counter : Counter.values()) {
      counters.put(counter.name().toLowerCase(Locale.ROOT), report.counters().get(counter));
    }
    done.put("counters", counters);
    Map<String, Object> violations = new LinkedHashMap<>();
    report.violations().entrySet().stream()
        .sorted(Map.Entry.comparingByKey())
        .forEach(
            entry ->
                violations.put(entry.getKey().name().toLowerCase(Locale.ROOT), entry.getValue()));
    done.put("violations", violations);
    done.put("warnings", report.warnings());
    List<Object> stages = new ArrayList<>();
    for (JobReport.Stage stage : report.stages()) {
      Map<String, Object> counts = new LinkedHashMap<>();
      counts.put("name", stage.name());
      counts.put("eventsIn", stage.timing().eventsIn());
      counts.put("eventsOut", stage.timing().eventsOut());
      stages.add(counts);
    }
    done.put("stages", stages);
    List<Object> outputs = new ArrayList<>();
    for (JobResults.ResultFile file : report.files()) {
      Map<String, Object> output = new LinkedHashMap<>();
      output.put("file", folder.relativize(file.path()).toString());
      output.put("rows", file.rows());
      output.put("bytes", Files.size(file.path()));
      output.put("sha256", Checksums.of(file.path()));
      outputs.add(output);
    }
    done.put("outputs", outputs);
    return done;
  }
}
