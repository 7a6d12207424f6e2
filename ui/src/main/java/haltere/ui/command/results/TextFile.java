package haltere.ui.command.results;

import haltere.core.format.AtomicFile;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;

/** A text file that appears whole or not at all. */
public final class TextFile {
  private TextFile() {}

  /** Writes a file; one that is there may have to be replaced. */
  public static void write(Path file, String text, boolean overwrite) throws IOException {
    try (AtomicFile atomic = AtomicFile.create(file, overwrite)) {
      atomic.stream().write(text.getBytes(StandardCharsets.UTF_8));
      atomic.commit();
    }
  }
}
