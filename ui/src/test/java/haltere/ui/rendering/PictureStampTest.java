package haltere.ui.rendering;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class PictureStampTest {
  @Test
  void scaleBarHasARoundLengthInSensorPixels() {
    BufferedImage picture = new BufferedImage(768, 768, BufferedImage.TYPE_INT_RGB);
    new PictureStamp(picture, true).scaleBar(6);
    int row = 768 - 6 - 7;
    int ink = picture.getRGB(10, row);
    int length = 0;
    while (picture.getRGB(6 + length, row) == ink) {
      length++;
    }
    assertEquals(20 * 6, length);
  }

  @Test
  void timeIsInTheUpperLeftCorner() {
    BufferedImage picture = new BufferedImage(768, 768, BufferedImage.TYPE_INT_RGB);
    new PictureStamp(picture, true).label("1");
    long inked =
        IntStream.range(0, 26 * 26)
            .filter(i -> picture.getRGB(i % 26, i / 26) != picture.getRGB(2, 2))
            .count();
    assertTrue(inked > 5, inked + " pixels");
    assertEquals(0xFF000000, picture.getRGB(300, 300));
  }
}
