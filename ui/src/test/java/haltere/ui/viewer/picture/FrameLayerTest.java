package haltere.ui.viewer.picture;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.Frame;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import org.junit.jupiter.api.Test;

/** Frames lie below the events, where the sensor was and as strong as was asked for. */
class FrameLayerTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(2, 2, Origin.TOP);
  private static final int BACKGROUND = 0x101010;
  private static final int EVENT = 69 << 24 | 0xFFA630;

  private final FrameLayer layer = new FrameLayer();

  /** One row of two grey pixels at the lower edge of the sensor. */
  private static Frame lowerRow(int left, int right) {
    return new Frame(
        new Frame.Times(100, 200),
        0,
        0,
        2,
        1,
        1,
        Frame.Depth.UNSIGNED_8,
        new byte[] {(byte) left, (byte) right});
  }

  private double opacity = 1;

  private int[] painted(int... ranked) {
    layer.paintUnder(ranked, SENSOR, BACKGROUND, opacity);
    return ranked;
  }

  @Test
  void frameReplacesOnlyTheBackground() {
    opacity = 1;
    layer.take(lowerRow(0xC0, 0xC0));
    assertArrayEquals(
        new int[] {BACKGROUND, EVENT, 0xC0C0C0, EVENT},
        painted(BACKGROUND, EVENT, BACKGROUND, EVENT));
  }

  /** One row of two grey pixels of 16 bits at the lower edge of the sensor. */
  private static Frame deepRow(int left, int right) {
    byte[] rows = {(byte) left, (byte) (left >> 8), (byte) right, (byte) (right >> 8)};
    return new Frame(new Frame.Times(1, 2), 0, 0, 2, 1, 1, Frame.Depth.UNSIGNED_16, rows);
  }

  private int[] lowerRow() {
    int[] pixels = painted(BACKGROUND, BACKGROUND, BACKGROUND, BACKGROUND);
    return new int[] {pixels[2] & 0xFF, pixels[3] & 0xFF};
  }

  @Test
  void framesOfMoreThan8BitsKeepTheirScale() {
    layer.take(deepRow(0x200, 0x3FF));
    assertArrayEquals(new int[] {0x80, 0xFF}, lowerRow(), "10 bits in 16");
    layer.take(deepRow(0x200, 0xFFFF));
    assertArrayEquals(new int[] {0x02, 0xFF}, lowerRow(), "16 bits");
    layer.take(deepRow(0x200, 0x3FF));
    assertArrayEquals(new int[] {0x02, 0x03}, lowerRow(), "a dark frame of 16 bits");
    layer.jump();
    layer.give(deepRow(0x200, 0x3FF));
    assertArrayEquals(new int[] {0x02, 0x03}, lowerRow(), "after a jump");
  }

  @Test
  void aDarkStartIsShownByTheBitsOfTheWholeRecording() {
    layer.take(deepRow(0x200, 0x3FF));
    lowerRow();
    layer.useBits(FrameLayer.usedBits(deepRow(0x200, 0xFFFF)));
    assertArrayEquals(new int[] {0x02, 0x03}, lowerRow(), "the frame that is shown");
    layer.take(deepRow(0x200, 0xFFFF));
    assertArrayEquals(new int[] {0x02, 0xFF}, lowerRow(), "the first bright one");
  }

  @Test
  void opacityMixesTheFrameWithTheBackground() {
    opacity = 0.5;
    layer.take(lowerRow(0x30, 0xF0));
    int[] pixels = painted(BACKGROUND, BACKGROUND, BACKGROUND, BACKGROUND);
    assertEquals(0x202020, pixels[2]);
    assertEquals(0x808080, pixels[3]);
    opacity = 0;
    assertEquals(BACKGROUND, painted(BACKGROUND, BACKGROUND, BACKGROUND, BACKGROUND)[2]);
  }

  @Test
  void seekRequestsTheFrameBeforeItsTimeUntilOneArrives() {
    opacity = 1;
    layer.take(lowerRow(1, 2));
    assertFalse(layer.isFrameRequested());
    layer.jump();
    assertTrue(layer.isFrameRequested());
    assertEquals(BACKGROUND, painted(BACKGROUND, BACKGROUND, BACKGROUND, BACKGROUND)[2]);
    assertTrue(layer.give(lowerRow(0x40, 0x50)));
    assertEquals(0x404040, painted(BACKGROUND, BACKGROUND, BACKGROUND, BACKGROUND)[2]);
    assertFalse(layer.give(lowerRow(0x60, 0x60)));
    assertEquals(0x404040, painted(BACKGROUND, BACKGROUND, BACKGROUND, BACKGROUND)[2]);
  }
}
