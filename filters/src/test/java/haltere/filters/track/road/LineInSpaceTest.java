package haltere.filters.track.road;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class LineInSpaceTest {
  private static final double HEIGHT_M = 5;

  private final LineInSpace ground = new LineInSpace(HEIGHT_M);
  private final LineInSpace other = new LineInSpace(HEIGHT_M);

  /** A line at a height, as it seems to be on the ground. */
  private static void seen(LineInSpace line, double x, double y, double v, double z) {
    double scale = HEIGHT_M / (HEIGHT_M - z);
    line.set(scale * x, scale * y, scale * v, 0.01, scale * 0.9);
  }

  @Test
  void theRoofBelongsToTheCarWhicheverWayItDrives() {
    for (double v : new double[] {16, -16}) {
      seen(ground, 1.75, 20, v, 0);
      seen(other, 1.75, 21, v, 1.4);
      assertTrue(other.isAbove(ground, 1));
      assertFalse(ground.isAbove(other, -1));
    }
  }

  @Test
  void aCarAheadDoesNot() {
    seen(ground, 1.75, 20, 16, 0);
    seen(other, 1.75, 30, 16, 0);
    assertFalse(other.isAbove(ground, 1), "as fast");
    seen(other, 5.25, 28, 22, 0);
    assertFalse(other.isAbove(ground, 1), "in another lane");
    seen(other, 1.75, 60, 20, 0);
    assertFalse(other.isAbove(ground, 1), "farther than a lorry is long");
    seen(other, 1.75, 29, 16, 1.4);
    assertFalse(other.isAbove(ground, 1), "not as high as a lorry, and farther than a car is long");
    seen(other, 1.75, 29, 16, 3.4);
    assertTrue(other.isAbove(ground, 1), "the roof of a lorry");
    seen(other, 1.75, 28, -22, 0);
    assertFalse(other.isAbove(ground, 1), "comes");
  }

  @Test
  void aSpeedThatIsNotKnownWellSaysNothing() {
    ground.set(1.75, 20, 16, 9, 0.9);
    other.set(2.4, 28, 22, 9, 1.2);
    assertFalse(other.isAbove(ground, 1));
  }
}
