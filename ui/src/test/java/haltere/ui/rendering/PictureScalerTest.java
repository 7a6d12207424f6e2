package haltere.ui.rendering;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PictureScalerTest {
  private static final int OPAQUE = 0xFF000000;
  private static final int BACKGROUND = 0x0D1117;
  private final PictureScaler scaler = new PictureScaler();

  @Test
  void integerScalesGiveBlocksOfPixels() {
    int[] target = new int[6 * 4];
    scaler.configure(3, 2, 0, 0, 2, 6, 4);
    scaler.scale(new int[] {1, 2, 3, 4, 5, 6}, target);
    assertArrayEquals(
        opaque(1, 1, 2, 2, 3, 3, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 4, 4, 5, 5, 6, 6), target);
  }

  @Test
  void partOfAPictureIsScaled() {
    int[] target = new int[4];
    scaler.configure(3, 2, 1, 1, 2, 2, 2);
    scaler.scale(new int[] {1, 2, 3, 4, 5, 6}, target);
    assertArrayEquals(opaque(5, 5, 5, 5), target);
  }

  @ParameterizedTest
  @ValueSource(doubles = {1, 1.3, 2.5, 4.75, 10, 63.9})
  void enlargedPictureUsesTheNearestPixels(double scale) {
    SplittableRandom random = new SplittableRandom(3);
    int width = 17;
    int height = 11;
    int[] source = random.ints((long) width * height).map(rgb -> rgb & 0xFFFFFF).toArray();
    int targetWidth = (int) (width * scale);
    int targetHeight = (int) (height * scale);
    int[] target = new int[targetWidth * targetHeight];
    scaler.configure(width, height, 0, 0, scale, targetWidth, targetHeight);
    scaler.scale(source, target);
    for (int y = 0; y < targetHeight; y++) {
      for (int x = 0; x < targetWidth; x++) {
        int expected = source[(int) ((y + 0.5) / scale) * width + (int) ((x + 0.5) / scale)];
        assertEquals(expected | OPAQUE, target[y * targetWidth + x], x + ", " + y);
      }
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.9, 0.675, 0.5, 0.31, 0.1})
  void reducedPictureShowsEveryEvent(double scale) {
    int width = 64;
    int height = 48;
    int targetWidth = (int) Math.ceil(width * scale);
    int targetHeight = (int) Math.ceil(height * scale);
    int[] target = new int[targetWidth * targetHeight];
    scaler.configure(width, height, 0, 0, scale, targetWidth, targetHeight);
    for (int pixel = 0; pixel < width * height; pixel++) {
      int[] source = new int[width * height];
      Arrays.fill(source, BACKGROUND);
      source[pixel] = ColourRanks.ranked(0x112233, BACKGROUND);
      scaler.scale(source, target);
      long seen = Arrays.stream(target).filter(colour -> colour == (0x112233 | OPAQUE)).count();
      assertTrue(seen >= 1 && seen <= 4, "pixel " + pixel + " is seen " + seen + " times");
    }
  }

  @Test
  void reducedPictureKeepsTheColourFarthestFromTheBackground() {
    int faded = ColourRanks.ranked(0x402010, BACKGROUND);
    int fresh = ColourRanks.ranked(0x4F8FE6, BACKGROUND);
    int nothing = ColourRanks.ranked(BACKGROUND, BACKGROUND);
    int[] target = new int[1];
    for (int[] source :
        List.of(
            new int[] {faded, fresh, nothing, nothing}, new int[] {nothing, faded, fresh, faded})) {
      scaler.configure(2, 2, 0, 0, 0.5, 1, 1);
      scaler.scale(source, target);
      assertEquals(0xFF4F8FE6, target[0]);
    }
    // on white it is the darkest
    scaler.scale(
        new int[] {
          ColourRanks.ranked(0xFFFFFF, 0xFFFFFF),
          ColourRanks.ranked(0xC05010, 0xFFFFFF),
          ColourRanks.ranked(0xF0E0D0, 0xFFFFFF),
          ColourRanks.ranked(0xFFFFFF, 0xFFFFFF)
        },
        target);
    assertEquals(0xFFC05010, target[0]);
  }

  private static int[] opaque(int... colours) {
    return Arrays.stream(colours).map(colour -> colour | OPAQUE).toArray();
  }
}
