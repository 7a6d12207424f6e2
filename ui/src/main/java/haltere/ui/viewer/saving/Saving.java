package haltere.ui.viewer.saving;

import haltere.core.chain.ChainFile;
import haltere.core.format.AtomicFile;
import haltere.ui.plot.PlotTable;
import haltere.ui.rendering.Pictures;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.picture.Overlays;
import haltere.ui.viewer.session.ViewerSession;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;

/**
 * Saves what is open, in the background. A file that is there is replaced.
 *
 * <p>Thread rule: JavaFX thread only; nothing here waits.
 */
public final class Saving {
  private final ViewerContext window;

  /** Saves what a window shows, and its chain. */
  public Saving(ViewerContext window) {
    this.window = window;
  }

  /** Saves the chain. */
  void chain(Path file) {
    window.editor().read(ChainFile::write, json -> text(file, json));
  }

  /** Saves what a session shows, with what lies over it. */
  void picture(Path file, ViewerSession open, Overlays overlays) {
    window
        .editor()
        .read(
            chain -> open.display().picture(overlays),
            image -> window.run(() -> Pictures.write(file, image)));
  }

  /** Saves what the plots show as numbers. */
  public void plots(Path file, PlotTable table) {
    text(file, table.text());
  }

  /** Saves what the plots look like. */
  public void plots(Path file, WritableImage image) {
    int width = (int) image.getWidth();
    int height = (int) image.getHeight();
    int[] argb = new int[width * height];
    image
        .getPixelReader()
        .getPixels(0, 0, width, height, PixelFormat.getIntArgbInstance(), argb, 0, width);
    BufferedImage copy = new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB);
    copy.setRGB(0, 0, width, height, argb, 0, width);
    window.run(() -> Pictures.write(file, copy));
  }

  private void text(Path file, String text) {
    window.run(() -> AtomicFile.write(file, text, true));
  }
}
