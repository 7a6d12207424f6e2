package haltere.ui.export;

import java.awt.image.BufferedImage;
import java.io.Closeable;
import java.io.IOException;

/**
 * Writes pictures of one size as a film. The file is atomic: without finishing, closing leaves
 * none.
 *
 * <p>Thread rule: one thread at a time.
 */
public interface FilmWriter extends Closeable {
  /** Adds a picture, as large as those before. */
  void add(BufferedImage image) throws IOException;

  /** Ends the film and moves the file to its path. */
  void finish() throws IOException;
}
