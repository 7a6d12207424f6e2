package haltere.ui.viewer.picture;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.Overlay;
import haltere.ui.rendering.Letters;
import haltere.ui.rendering.OverlaySnapshots;
import haltere.ui.rendering.PictureStamp;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(value = 60, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class PictureRendererTest {
  /** The marks of the filters alone. */
  static final Overlays MARKS_ALONE = new Overlays(true, Optional.empty(), Optional.empty());

  private static final SensorGeometry SENSOR = new SensorGeometry(64, 48);

  /** Words take no room and are not to be seen. */
  private static final Letters NO_LETTERS =
      new Letters() {
        @Override
        public double width(String line) {
          return 0;
        }

        @Override
        public double ascent() {
          return 0;
        }

        @Override
        public double descent() {
          return 0;
        }

        @Override
        public void draw(String line, int left, int base, Dots dots) {}
      };

  private static final ScreenMapping PLACE = place(true);

  private static ScreenMapping place(boolean marks) {
    return new ScreenMapping(0, 0, 0.7, 1, 45, 34, 0, 33.6, NO_LETTERS, marks);
  }

  private static final Overlay<Double> RING =
      (radius, canvas) -> canvas.circle(30, 20, radius, MarkStyle.of(Role.OBJECT));

  private static final List<OverlaySnapshots.Marks<?>> MARKS =
      List.of(new OverlaySnapshots.Marks<>(9.0, RING));

  private static EventPacket events(long fromUs) {
    EventPacket packet = new EventPacket(16);
    for (int i = 0; i < 16; i++) {
      packet.append(fromUs + i, 4 * i, 3 * i, i % 2 == 0);
    }
    return packet;
  }

  private static PictureRenderer renderer(boolean betweenSlices) {
    return new PictureRenderer(SENSOR, DisplayOptions.DEFAULT, betweenSlices, Optional.empty());
  }

  @Test
  void screenFrameEqualsTheDrawingOfTheWindow() {
    PictureRenderer renderer = renderer(false);
    renderer.setScreenMapping(Optional.of(PLACE));
    renderer.packet(events(1000));
    renderer.showSlice(0, 2000, MARKS);
    DisplayFrame frame = renderer.exchange().fetch();
    assertEquals(Optional.of(PLACE), frame.screenMapping);
    int[] drawn = new int[45 * 34];
    ScreenPainter painter = new ScreenPainter();
    painter.configure(SENSOR, PLACE);
    painter.paint(frame, drawn);
    assertArrayEquals(drawn, frame.screen);
    painter.configure(SENSOR, place(false));
    painter.paint(frame, drawn);
    assertFalse(Arrays.equals(drawn, frame.screen), "marks can be seen, and left out");
  }

  @Test
  void frameWithoutScreenPlaceHasOnlySensorPixels() {
    PictureRenderer renderer = renderer(false);
    renderer.packet(events(1000));
    renderer.showSlice(0, 2000, MARKS);
    DisplayFrame frame = renderer.exchange().fetch();
    assertEquals(Optional.empty(), frame.screenMapping);
    assertEquals(0, frame.screen.length);
  }

  @Test
  void savedPictureNamesTheStartOfItsSlice() {
    PictureRenderer renderer = renderer(false);
    renderer.showSlice(2000, 4000, List.of());
    BufferedImage saved = renderer.picture(MARKS_ALONE, List.of());
    BufferedImage expected = new BufferedImage(saved.getWidth(), 26, BufferedImage.TYPE_INT_RGB);
    for (int i = 0; i < expected.getWidth() * expected.getHeight(); i++) {
      int background = DisplayOptions.DEFAULT.colours().background();
      expected.setRGB(i % expected.getWidth(), i / expected.getWidth(), background);
    }
    new PictureStamp(expected, true).label("2000 \u00b5s");
    for (int x = 0; x < 80; x++) {
      for (int y = 0; y < 26; y++) {
        assertEquals(expected.getRGB(x, y), saved.getRGB(x, y), x + ", " + y);
      }
    }
  }

  @Test
  void continuousSlicesYieldFramesBeforeTheirEnd() {
    PictureRenderer renderer = renderer(true);
    runOn(renderer);
    DisplayFrame frame = null;
    for (long us = 5000; frame == null; us += 20) {
      renderer.packet(events(us));
      frame = renderer.exchange().fetch();
    }
    assertNotNull(frame, "there is a frame although no slice has ended");
    assertEquals(MARKS, frame.marks);
  }

  @Test
  void directPictureIsShownOnlyAfterTheWholeSlice() {
    PictureRenderer renderer = renderer(false);
    runOn(renderer);
    long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(10);
    for (long us = 5000; System.nanoTime() < end; us += 20) {
      renderer.packet(events(us));
      assertNull(renderer.exchange().fetch());
    }
  }

  /** Two slices, one right after the other. */
  private static void runOn(PictureRenderer renderer) {
    long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(30);
    boolean atOnce = false;
    while (!atOnce && System.nanoTime() < end) {
      long start = System.nanoTime();
      renderer.showSlice(0, 2000, MARKS);
      renderer.exchange().fetch();
      renderer.showSlice(2000, 4000, MARKS);
      renderer.exchange().fetch();
      atOnce = System.nanoTime() - start < TimeUnit.MILLISECONDS.toNanos(15);
    }
  }
}
