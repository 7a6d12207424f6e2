package haltere.testing.evaluation;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

/** Whether tracks on a simulated road with vehicles as high as they are know what they know. */
class RoadHonestyTest {
  private static final int SCENES = 10;

  @Test
  void vehiclesAreWhereAndAsFastAsTracksSayWithinTheirStandardDeviations() {
    RoadHonesty honesty =
        RoadEvaluation.of(605_000, SCENES, "20", List.of("traffic.pauseS=5")).honesty();
    assertTrue(honesty.speed().count() > 100, "passages");
    assertAll(
        () -> assertIn95(honesty.speed(), "speed"),
        () -> assertIn95(honesty.along(), "place along the road"),
        () -> assertIn95(honesty.across(), "place across the road"),
        () -> assertNotBelow95(honesty.innovations()));
  }

  private static void assertIn95(Share share, String of) {
    assertEquals(0.95, share.within(), share.chance(), of);
  }

  /**
   * Rows are held to be less exact than simulated pixels are, for those of cameras are not so good.
   */
  private static void assertNotBelow95(Share share) {
    assertTrue(share.within() >= 0.95 - share.chance(), "innovations: " + share.within());
  }
}
