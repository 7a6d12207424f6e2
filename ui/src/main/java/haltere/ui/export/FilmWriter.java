package haltere.ui.export;

import java.awt.image.BufferedImage;
import java.io.Closeable;
import java.io.IOException;

/**
 * Writes pictures of one size as a film. The file appears when it is finished; closing without that
 * leaves nothing.
 *
 * <p>Thread rule: one thread at a time.
 */
public interface FilmWriter extends Closeable {
  /**
   * Adds a picture.
   *
   * @param image as large as those before
   * @throws IOException if it cannot be written
   */
  void add(BufferedImage image) throws IOException;

  /**
   * Ends the film and puts the file in its place.
   *
   * @throws IOException if that fails
   */
  void finish() throws IOException;
}
