package haltere.testing.faults;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * The installed program, in a process of its own whose disk and clock fail by src/faults/faults.c.
 */
final class FaultyProgram {
  private static final Path PROGRAM =
      Path.of(System.getProperty("haltere.installed", ""), "bin", "haltere");
  private static final String SHIM = System.getProperty("haltere.faults", "");
  private static final int PATIENCE_S = 240;

  /**
   * How a run ended.
   *
   * @param status exit status
   * @param messages lines of standard error
   */
  record Ended(int status, List<String> messages) {
    /** Asserts that a line names the file and its cause, and that none is for developers. */
    void saysOf(String file, String cause) {
      assertTrue(status == 1, () -> status + " " + messages);
      assertTrue(
          messages.stream().anyMatch(line -> line.contains(file) && line.contains(cause)),
          () -> file + ", " + cause + ": " + messages);
      isClear();
    }

    /** Asserts success. */
    Ended wentWell() {
      assertTrue(status == 0, () -> status + " " + messages);
      isClear();
      return this;
    }

    private void isClear() {
      for (String line : messages) {
        assertFalse(line.contains("Exception") || line.startsWith("\tat "), messages::toString);
        assertFalse(line.contains("fault in"), messages::toString);
      }
    }
  }

  private FaultyProgram() {}

  /**
   * Runs it to its end.
   *
   * @param faults environment of the process, as faults.c names them
   * @param notes where its messages go
   * @param arguments of the program
   * @return how it ended
   */
  static Ended run(Map<String, ?> faults, Path notes, Object... arguments) throws IOException {
    List<String> line = new ArrayList<>(List.of(PROGRAM.toString()));
    Stream.of(arguments).map(Object::toString).forEach(line::add);
    ProcessBuilder builder =
        new ProcessBuilder(line)
            .redirectError(notes.toFile())
            .redirectOutput(ProcessBuilder.Redirect.DISCARD);
    builder.environment().put("LD_PRELOAD", SHIM);
    faults.forEach((name, value) -> builder.environment().put(name, value.toString()));
    Process process = builder.start();
    try {
      if (!process.waitFor(PATIENCE_S, TimeUnit.SECONDS)) {
        fail(faults + " " + line + " hangs: " + Files.readAllLines(notes));
      }
    } catch (InterruptedException stop) {
      Thread.currentThread().interrupt();
      throw new IOException(stop);
    } finally {
      process.destroyForcibly();
    }
    return new Ended(process.exitValue(), Files.readAllLines(notes));
  }
}
