package haltere.testing.peers;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Assumptions;

/**
 * Other programs that read and write the same formats, behind a script that uses them. Needs a
 * Python that has them: the one that the environment's HALTERE_PEERS names, else the one in
 * build/peers, where the continuous build installs them.
 */
final class PythonPrograms {
  private static final int LIMIT_S = 120;

  private final Path script;
  private final Path folder;

  private PythonPrograms(Path script, Path folder) {
    this.script = script;
    this.folder = folder;
  }

  /** The programs that a script uses; the running test is skipped if they are not there. */
  static PythonPrograms orSkip(String name, Path folder) throws IOException {
    Path script = folder.resolve(name);
    try (InputStream in = PythonPrograms.class.getResourceAsStream("/peers/" + name)) {
      Files.copy(in, script);
    }
    PythonPrograms programs = new PythonPrograms(script, folder);
    Assumptions.assumeTrue(
        Files.isExecutable(python()) && programs.run("check").isPresent(),
        "there is no Python with what " + name + " imports (HALTERE_PEERS names one)");
    return programs;
  }

  /**
   * An example of the repository, or another script by its path; the running test is skipped if
   * what it imports is not there.
   */
  static PythonPrograms exampleOrSkip(String name, Path folder, String... imports)
      throws IOException {
    Path check = folder.resolve("imports.py");
    Files.writeString(check, "import " + String.join(", ", imports) + "\n");
    Assumptions.assumeTrue(
        Files.isExecutable(python()) && new PythonPrograms(check, folder).run().isPresent(),
        "there is no Python with what " + name + " imports (HALTERE_PEERS names one)");
    return new PythonPrograms(Path.of("../examples/python").resolve(name), folder);
  }

  /** Messages of the last failed script. */
  String errors() {
    try {
      return Files.readString(folder.resolve("errors.txt"));
    } catch (IOException none) {
      return "";
    }
  }

  private static Path python() {
    String named = System.getenv("HALTERE_PEERS");
    return named != null ? Path.of(named) : Path.of("../build/peers/bin/python3");
  }

  /** Lines that the script printed, empty if it failed. */
  Optional<List<String>> run(String... arguments) throws IOException {
    List<String> command = new ArrayList<>(List.of(python().toString(), script.toString()));
    command.addAll(Arrays.asList(arguments));
    Path errors = folder.resolve("errors.txt");
    Path printed = folder.resolve("printed.txt");
    Process process =
        new ProcessBuilder(command)
            .redirectError(errors.toFile())
            .redirectOutput(printed.toFile())
            .start();
    try {
      boolean done = process.waitFor(LIMIT_S, TimeUnit.SECONDS) && process.exitValue() == 0;
      return done ? Optional.of(Files.readAllLines(printed)) : Optional.empty();
    } catch (InterruptedException e) {
      throw new IOException(e);
    } finally {
      process.descendants().forEach(ProcessHandle::destroyForcibly);
      process.destroyForcibly();
    }
  }
}
