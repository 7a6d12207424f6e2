package haltere.filters.wing.internal.stroke;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class RunAwayTest {
  private static final double DT_S = 1e-3;
  private static final double OMEGA = 2 * Math.PI * 200;

  /**
   * Two wings that are driven together, each with a phase that is off, worth 1000 a squared radian.
   */
  private static RunAway[] wings(double leftOff, double rightOff) {
    RunAway[] wings = {new RunAway(), new RunAway()};
    double[] off = {leftOff, rightOff};
    for (int side = 0; side < 2; side++) {
      wings[side].add(off[side], 1000, 1);
    }
    wings[0].look(DT_S, OMEGA, 4e4, wings[1]);
    return wings;
  }

  @Test
  void whatNeitherWingTellsAloneBothTellTogether() {
    assertTrue(wings(0.12, 0.12)[0].density() > 1000);
    RunAway alone = new RunAway();
    alone.add(0.12, 1000, 1);
    alone.look(DT_S, OMEGA, 4e4, null);
    assertEquals(0, alone.density());
  }

  @Test
  void phasesThatAreOffAgainstEachOtherAreNoise() {
    assertEquals(0, wings(0.12, -0.12)[0].density());
  }

  @Test
  void aWingThatClearlyRunsAwayAloneIsFollowedAndThenLetGo() {
    RunAway[] wings = wings(0.25, -0.25);
    assertTrue(wings[0].density() > 1000);
    for (int i = 0; i < 600; i++) {
      for (int side = 0; side < 2; side++) {
        wings[side].add(0, 100, 1);
        wings[side].look(DT_S, OMEGA, 4e4, wings[1 - side]);
      }
    }
    assertEquals(0, wings[0].density());
  }
}
