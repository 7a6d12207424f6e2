package haltere.filters.wing.internal.stroke;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class ManoeuvreDetectorTest {
  private static final double DT_S = 1e-3;
  private static final double OMEGA = 2 * Math.PI * 200;

  /**
   * Two wings of one fly, each with a phase error and an information of 1000 per squared radian.
   */
  private static ManoeuvreDetector[] wings(double leftOff, double rightOff) {
    ManoeuvreDetector[] wings = {new ManoeuvreDetector(), new ManoeuvreDetector()};
    double[] off = {leftOff, rightOff};
    for (int side = 0; side < 2; side++) {
      wings[side].add(off[side], 1000, 1);
    }
    wings[0].update(DT_S, OMEGA, 4e4, wings[1]);
    return wings;
  }

  @Test
  void smallErrorIsDetectedInBothWingsTogether() {
    assertTrue(wings(0.12, 0.12)[0].density() > 1000);
    ManoeuvreDetector alone = new ManoeuvreDetector();
    alone.add(0.12, 1000, 1);
    alone.update(DT_S, OMEGA, 4e4, null);
    assertEquals(0, alone.density());
  }

  @Test
  void oppositeErrorsOfBothWingsAreNoise() {
    assertEquals(0, wings(0.12, -0.12)[0].density());
  }

  @Test
  void largeErrorOfOneWingIsDetectedAndTheNoiseDecays() {
    ManoeuvreDetector[] wings = wings(0.25, -0.25);
    assertTrue(wings[0].density() > 1000);
    for (int i = 0; i < 600; i++) {
      for (int side = 0; side < 2; side++) {
        wings[side].add(0, 100, 1);
        wings[side].update(DT_S, OMEGA, 4e4, wings[1 - side]);
      }
    }
    assertEquals(0, wings[0].density());
  }
}
