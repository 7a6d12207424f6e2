package haltere.filters.wing.tracker;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.filters.estimation.Angles;
import haltere.filters.wing.FlyGeometry;
import haltere.filters.wing.WingTrackerSettings;
import haltere.filters.wing.internal.search.FoundFly;
import haltere.filters.wing.internal.stroke.StrokeFrame;
import haltere.filters.wing.internal.stroke.StrokeSeed;
import org.junit.jupiter.api.Test;

class PixelAnglesTest {
  private static final FlyGeometry FOUND =
      new FlyGeometry(60.3, 66.8, 2.1, 40, 57.9, 65.2, 62.7, 68.4, 1, 0);

  private static FlyPosition place() {
    FlyPosition place = new FlyPosition();
    place.begin(
        new FoundFly(FOUND, 42, new StrokeSeed[2]), WingTrackerSettings.defaults().position(), 0);
    return place;
  }

  @Test
  void pixelsHaveSideAndAngleOfTheirWingFrame() {
    FlyPosition place = place();
    PixelAngles angles = new PixelAngles(128, 128, place);
    int inside = 0;
    for (int round = 0; round < 2; round++) {
      for (int y = 0; y < 128; y++) {
        for (int x = 0; x < 128; x++) {
          StrokeFrame frame = place.frames[place.side(x, y)];
          float code = angles.code(x, y);
          if (!frame.look(x, y)) {
            assertTrue(Float.isNaN(code));
            continue;
          }
          inside++;
          assertEquals(place.side(x, y), PixelAngles.side(code));
          double expected = Angles.wrapTwoPi(frame.angle());
          assertEquals(expected, PixelAngles.angle(code), 5e-7);
        }
      }
    }
    assertTrue(inside > 5000, inside + " pixels in the region of interest");
  }

  @Test
  void anglesAreRecomputedAfterAMoveOfTheFly() {
    FlyPosition place = place();
    PixelAngles angles = new PixelAngles(128, 128, place);
    double before = PixelAngles.angle(angles.code(80, 80));
    place.turn(0.25);
    place.settle();
    assertEquals(before, PixelAngles.angle(angles.code(80, 80)));
    angles.clear();
    // the right wing's angles are clockwise of the heading
    assertEquals(before + 0.25, PixelAngles.angle(angles.code(80, 80)), 1e-6);
  }
}
