package haltere.filters.wing.tracker;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/**
 * Draws into build/pictures; {@code ./gradlew :filters:refreshPictures} takes the pictures over.
 */
class WingPicturesTest {
  private static final Path FOLDER = Path.of("build", "pictures");

  @Test
  void filterIsNearTheTruthThroughoutTheStroke() throws IOException {
    double worst = WingPictures.stroke(FOLDER);
    assertTrue(worst < 4, "worst error in degrees: " + worst);
  }

  @Test
  void filterFollowsAManoeuvre() throws IOException {
    double rms = WingPictures.manoeuvre(FOLDER);
    assertTrue(rms < 0.6, "error in hertz: " + rms);
  }
}
