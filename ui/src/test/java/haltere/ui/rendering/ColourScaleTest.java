package haltere.ui.rendering;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** What the ends of a gradient stand for, on pictures. */
class ColourScaleTest {
  @Test
  void agesEndAtNowAndCountsStartAtZero() {
    assertEquals(
        Optional.of(new ColourScale(Gradient.GREY, "20 ms ago", "now")),
        ColourScale.of(DisplayMode.TIME_SURFACE, Gradient.GREY, "20 ms ago"));
    assertEquals(
        Optional.of(new ColourScale(Gradient.GREY, "0", "7 events")),
        ColourScale.of(DisplayMode.COUNTS, Gradient.GREY, "7 events"));
    assertEquals(Optional.empty(), ColourScale.of(DisplayMode.POLARITY, Gradient.GREY, "7 events"));
    assertEquals(Optional.empty(), ColourScale.of(DisplayMode.COUNTS, Gradient.GREY, ""));
  }

  @Test
  void scaleShowsAllColoursInTheCorner() {
    BufferedImage image = new BufferedImage(400, 300, BufferedImage.TYPE_INT_RGB);
    new PictureStamp(image, true).colours(new ColourScale(Gradient.GREY, "0", "9"));
    int row = 300 - 6 - 6 - 7;
    int first = -1;
    int last = -1;
    int before = 0;
    int right = 400 - 6 - 6 - (int) FontLetters.OF_PICTURES.width("9") - 6;
    for (int x = right - 90; x < right; x++) {
      int grey = image.getRGB(x, row) & 0xFF;
      assertTrue(grey >= before, "lighter and lighter");
      before = grey;
      first = first < 0 ? grey : first;
      last = grey;
    }
    assertEquals(0, first);
    assertEquals(0xFF, last);
    assertEquals(0xFF000000, image.getRGB(100, row), "nothing elsewhere");
  }

  @Test
  void scaleInANarrowPictureIsShorterAndLeavesTheScaleBar() {
    BufferedImage image = new BufferedImage(160, 160, BufferedImage.TYPE_INT_RGB);
    PictureStamp stamp = new PictureStamp(image, true);
    stamp.scaleBar(6);
    int[] bar = image.getRGB(0, 134, 160, 26, null, 0, 160);
    stamp.colours(new ColourScale(Gradient.GREY, "0", "12 events"));
    assertArrayEquals(bar, image.getRGB(0, 134, 160, 26, null, 0, 160), "the scale bar");
    int right = 160 - 6 - 6 - (int) FontLetters.OF_PICTURES.width("12 events") - 6;
    int row = 160 - 26 - 6 - 6 - 7;
    assertEquals(0xFF, image.getRGB(right - 1, row) & 0xFF, "the lightest colour");
    assertTrue((image.getRGB(right - 20, row) & 0xFF) < 0xFF, "a strip");
    assertEquals(0xFF000000, image.getRGB(2, 20), "nothing above");
  }

  @Test
  void pictureWithoutSpaceForTheScaleIsUnchanged() {
    BufferedImage image = new BufferedImage(60, 60, BufferedImage.TYPE_INT_RGB);
    new PictureStamp(image, true).colours(new ColourScale(Gradient.GREY, "0", "9"));
    for (int y = 0; y < 60; y++) {
      for (int x = 0; x < 60; x++) {
        assertEquals(0xFF000000, image.getRGB(x, y));
      }
    }
  }
}
