package haltere.testing;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.Assumptions;

/**
 * Finds the real recordings that tests read: in the folder that the system property {@code
 * haltere.recordings} names, else the environment variable {@code HALTERE_RECORDINGS}, else {@code
 * ../shared/recordings} beside the checkout; missing ones among the few of the repository ({@code
 * src-test/recordings}). A test whose recording is nowhere is skipped and says why; where the
 * environment variable {@code CI} is {@code true} it fails.
 */
public final class Recorded {
  private static final Path OURS = Path.of("../src-test/recordings");

  private Recorded() {}

  /**
   * The folder of the recordings, whether it is there or not.
   *
   * @return its path
   */
  public static Path folder() {
    String property = System.getProperty("haltere.recordings", "");
    if (!property.isEmpty()) {
      return Path.of(property);
    }
    String variable = System.getenv("HALTERE_RECORDINGS");
    return Path.of(variable == null || variable.isEmpty() ? "../../shared/recordings" : variable);
  }

  /**
   * Where a recording is: in the folder, or else in the repository.
   *
   * @param name of the file
   * @return its path, in the folder if it is in neither
   */
  public static Path path(String name) {
    Path file = folder().resolve(name);
    Path ours = OURS.resolve(name);
    return !Files.isReadable(file) && Files.isReadable(ours) ? ours : file;
  }

  /**
   * A recording for the running test; the test ends here if it is missing.
   *
   * @param name of the file
   * @return a readable file
   */
  public static Path file(String name) {
    Path file = path(name);
    if (!Files.isReadable(file)) {
      String reason =
          "the recording " + name + " is not in " + folder() + " (-Dhaltere.recordings names it)";
      if ("true".equals(System.getenv("CI"))) {
        Assertions.fail(reason);
      }
      Assumptions.abort(reason);
    }
    return file;
  }
}
