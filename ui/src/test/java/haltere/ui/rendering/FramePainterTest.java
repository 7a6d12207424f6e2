package haltere.ui.rendering;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import haltere.core.stream.Reset;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class FramePainterTest {
  private static final ColourMap MAP = ColourMap.DARK;
  private final EventFrame frame = new EventFrame(new SensorGeometry(3, 2));
  private final int[] argb = new int[6];

  @Test
  void newEventsHaveFullColourAndRowsStartAtTheTop() {
    frame.packet(EventFrameTest.one(500, 0, 1, true));
    frame.packet(EventFrameTest.one(500, 2, 0, false));
    new FramePainter(MAP, 1000).paint(frame, argb);
    int none = MAP.background();
    assertArrayEquals(new int[] {MAP.on(), none, none, none, none, MAP.off()}, argb);
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 10, 999, 20_000, 3_000_000, 20_000_000})
  void coloursFadeExponentially(long timeConstantUs) {
    frame.packet(EventFrameTest.one(77, 1, 0, true));
    FramePainter painter = new FramePainter(MAP, timeConstantUs);
    for (int step = 0; step <= 5; step++) {
      frame.advanceTo(77 + step * timeConstantUs);
      painter.paint(frame, argb);
      int expected = MAP.colour(true, Math.exp(-step));
      for (int shift = 0; shift <= 16; shift += 8) {
        assertEquals(expected >> shift & 0xFF, argb[4] >> shift & 0xFF, 1.0, "step " + step);
      }
    }
    frame.advanceTo(77 + 8 * timeConstantUs);
    painter.paint(frame, argb);
    assertEquals(MAP.background(), argb[4]);
  }

  @Test
  void rewindClearsThePicture() {
    FramePainter painter = new FramePainter(MAP, 1000);
    frame.packet(EventFrameTest.one(1_000_000, 1, 0, true));
    frame.notified(new Reset(Reset.Cause.REWIND));
    painter.paint(frame, argb);
    assertTrue(Arrays.stream(argb).allMatch(colour -> colour == MAP.background()));
    frame.packet(EventFrameTest.one(10, 0, 0, false));
    painter.paint(frame, argb);
    assertEquals(MAP.background(), argb[4]);
    assertEquals(MAP.off(), argb[3]);
  }

  @Test
  void colourMapsAreOpaqueAndDistinguishPolarities() {
    for (ColourMap map : ColourMap.all()) {
      for (int colour : new int[] {map.background(), map.on(), map.off(), map.colour(true, 0.5)}) {
        assertEquals(0xFF, colour >>> 24, map.name());
      }
      assertTrue(contrast(map.on(), map.background()) > 2.5, map.name());
      assertTrue(contrast(map.off(), map.background()) > 2.5, map.name());
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {0, -1, FramePainter.MAX_TIME_CONSTANT_US + 1})
  void timeConstantOutOfRangeIsRejected(long timeConstantUs) {
    assertThrows(IllegalArgumentException.class, () -> new FramePainter(MAP, timeConstantUs));
  }

  /** Contrast ratio as the web's accessibility guidelines define it. */
  private static double contrast(int a, int b) {
    double lighter = Math.max(luminance(a), luminance(b));
    double darker = Math.min(luminance(a), luminance(b));
    return (lighter + 0.05) / (darker + 0.05);
  }

  private static double luminance(int argb) {
    return 0.2126 * linear(argb >> 16 & 0xFF)
        + 0.7152 * linear(argb >> 8 & 0xFF)
        + 0.0722 * linear(argb & 0xFF);
  }

  private static double linear(int channel) {
    double share = channel / 255.0;
    return share <= 0.04045 ? share / 12.92 : Math.pow((share + 0.055) / 1.055, 2.4);
  }
}
