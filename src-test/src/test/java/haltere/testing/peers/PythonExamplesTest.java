package haltere.testing.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.batch.Batch;
import haltere.core.batch.BatchFailure;
import haltere.core.batch.BatchInputs;
import haltere.core.batch.BatchItem;
import haltere.core.batch.BatchOptions;
import haltere.core.chain.FilterChain;
import haltere.core.chain.Filters;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.core.simulation.Scene;
import haltere.core.simulation.Scenes;
import haltere.testing.SceneEvents;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/**
 * The Python examples of the repository on results of a batch. Needs {@link PythonPrograms};
 * skipped without.
 */
class PythonExamplesTest {
  private static final Path PROGRAM =
      Path.of(System.getProperty("haltere.installed"), "bin", "haltere");

  @TempDir Path folder;
  private Path in;
  private Path out;

  /** Hears nothing. */
  private static final Batch.Listener QUIET =
      new Batch.Listener() {
        @Override
        public void progress(long doneBytes, long totalBytes) {}

        @Override
        public void failed(BatchFailure failure) {}

        @Override
        public void warned(BatchItem item, String warning) {}
      };

  @BeforeEach
  void simulateAFly() throws IOException {
    in = Files.createDirectories(folder.resolve("in"));
    out = folder.resolve("out");
    simulate("fly", in.resolve("fly.aedat"));
  }

  private static void simulate(String name, Path file) throws IOException {
    try (Scene<?> scene = Scenes.named(name).create(List.of("run.durationS=0.3"));
        RecordingWriter writer =
            Recordings.forWriting(file)
                .create(file, WriteOptions.of(scene.geometry()))
                .orElseThrow()) {
      writer.write(SceneEvents.of(scene));
      writer.finish();
    }
  }

  private void batch(String tables) throws IOException {
    BatchInputs inputs = new BatchInputs(out, Optional.empty());
    inputs.add(in);
    BatchOptions options =
        new BatchOptions(
            out,
            1,
            BatchOptions.Existing.REFUSE,
            ReadOptions.DEFAULT,
            false,
            "haltere test",
            tables,
            Set.of());
    int done =
        new Batch(PythonExamplesTest::wings, options, Throwable::toString)
            .run(inputs.items(), "failed.json", QUIET)
            .done();
    assertEquals(1, done);
  }

  private static FilterChain wings(SensorGeometry sensor) {
    FilterChain chain = new FilterChain(sensor);
    chain.add(Filters.named("wing-tracker"));
    return chain;
  }

  @Test
  void batchToNwbExampleWritesValidFilesWithEvents() throws IOException {
    PythonPrograms script =
        PythonPrograms.exampleOrSkip("batch_to_nwb.py", folder, "pynwb.event", "pyarrow");
    for (String tables : List.of("csv", "parquet")) {
      out = folder.resolve(tables);
      batch(tables);
      Path nwb = folder.resolve("nwb-" + tables);
      String[] arguments = {
        out.toString(),
        nwb.toString(),
        "--recordings",
        in.toString(),
        "--haltere",
        PROGRAM.toString()
      };
      assertEquals(
          Optional.of(List.of("wrote " + nwb.resolve("fly.aedat.nwb") + " (valid)")),
          script.run(arguments),
          script::errors);
      assertEquals(Optional.empty(), script.run(arguments), "it exists already");
      assertTrue(script.errors().contains("--overwrite"), script::errors);
    }
  }

  @Test
  void plotWingsExampleWritesAPicture() throws IOException {
    PythonPrograms script =
        PythonPrograms.exampleOrSkip("plot_wings.py", folder, "matplotlib", "pyarrow");
    for (String tables : List.of("csv", "parquet")) {
      out = folder.resolve(tables);
      batch(tables);
      Path picture = folder.resolve(tables + ".png");
      Path table = out.resolve("fly.aedat/wing-tracker.wings." + tables);
      assertTrue(script.run(table.toString(), picture.toString()).isPresent(), script::errors);
      assertTrue(ImageIO.read(picture.toFile()).getWidth() > 500);
    }
  }

  @Test
  void plotWingsExampleNamesAFileThatItCannotUseInOneLine() throws IOException {
    PythonPrograms script =
        PythonPrograms.exampleOrSkip("plot_wings.py", folder, "matplotlib", "pyarrow");
    Path damaged = Files.writeString(folder.resolve("damaged.parquet"), "PAR1");
    for (Path table :
        List.of(folder.resolve("none.csv"), folder.resolve("none.parquet"), damaged)) {
      assertEquals(Optional.empty(), script.run(table.toString(), "picture.png"));
      String errors = script.errors();
      assertTrue(errors.startsWith(table + " cannot be read: "), errors);
      assertEquals(1, errors.strip().lines().count(), errors);
    }
    batch("csv");
    String table = out.resolve("fly.aedat/wing-tracker.wings.csv").toString();
    assertEquals(Optional.empty(), script.run(table, "picture.wmv"));
    assertTrue(script.errors().startsWith("picture.wmv cannot be written: "), script::errors);
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void examplesRunByTheirNamesAsInTheDocuments() {
    for (String name : List.of("batch_to_nwb.py", "plot_wings.py")) {
      assertTrue(Files.isExecutable(Path.of("../examples/python", name)), name);
    }
  }

  @Test
  void jPypeExampleTracksObjects() throws IOException {
    Path recording = folder.resolve("recording.aedat");
    simulate("dots", recording);
    Matcher lines =
        Pattern.compile("```python\n(.*?)```", Pattern.DOTALL)
            .matcher(Files.readString(Path.of("../docs/embedding.md")));
    assertTrue(lines.find());
    Path file =
        Files.writeString(
            folder.resolve("lines.py"),
            lines
                    .group(1)
                    .replace("ui/build/install/haltere", PROGRAM.getParent().getParent().toString())
                    .replace("recording.aedat", recording.toString())
                + "for row in rows: print(*row)\n");
    PythonPrograms script = PythonPrograms.exampleOrSkip(file.toString(), folder, "jpype.imports");
    List<String> rows = script.run().orElseThrow(() -> new AssertionError(script.errors()));
    assertTrue(rows.size() > 5, rows::toString);
    assertTrue(rows.stream().allMatch(row -> row.matches("\\d+ \\d+ [\\d.]+ [\\d.]+")));
  }
}
