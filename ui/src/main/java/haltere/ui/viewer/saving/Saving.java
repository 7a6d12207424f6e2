package haltere.ui.viewer.saving;

import haltere.core.chain.ChainFile;
import haltere.core.format.AtomicFile;
import haltere.ui.plot.PlotTable;
import haltere.ui.rendering.Pictures;
import haltere.ui.viewer.chain.ChainEditor;
import haltere.ui.viewer.controls.Texts;
import haltere.ui.viewer.feature.BackgroundWork;
import haltere.ui.viewer.picture.Overlays;
import haltere.ui.viewer.session.ViewerSession;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.function.Consumer;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;

/**
 * Saves what is open, in the background. A file that is there is replaced.
 *
 * <p>Thread rule: JavaFX thread only; nothing here waits.
 */
public final class Saving {
  /** Writes a file. */
  private interface Work {
    void run() throws IOException;
  }

  private final BackgroundWork background;
  private final ChainEditor editor;
  private final Consumer<String> problems;

  /**
   * Saves what a window shows and the chain of an editor in the background; tells in one line what
   * went wrong.
   */
  public Saving(BackgroundWork background, ChainEditor editor, Consumer<String> problems) {
    this.background = background;
    this.editor = editor;
    this.problems = problems;
  }

  /** Saves the chain. */
  void chain(Path file) {
    editor.read(ChainFile::write, json -> later(() -> text(file, json)));
  }

  /** Saves what a session shows, with what lies over it. */
  void picture(Path file, ViewerSession open, Overlays overlays) {
    editor.read(
        chain -> open.display().picture(overlays),
        image -> later(() -> Pictures.write(file, image)));
  }

  /** Saves what the plots show as numbers. */
  public void plots(Path file, PlotTable table) {
    later(() -> text(file, table.text()));
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
    later(() -> Pictures.write(file, copy));
  }

  private static void text(Path file, String text) throws IOException {
    try (AtomicFile output = AtomicFile.create(file, true)) {
      output.stream().write(text.getBytes(StandardCharsets.UTF_8));
      output.commit();
    }
  }

  private void later(Work work) {
    background.file(
        () -> {
          work.run();
          return work;
        },
        done -> {},
        problem -> problems.accept(Texts.oneLine(problem)));
  }
}
