package haltere.testing.wings;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class NeesBandTest {
  private static final int SCENES = 200;

  /**
   * Scenes whose errors are partly the same throughout and opposite on both wings, as those of a
   * heading, and partly follow each other for some ticks.
   *
   * @param scale of the errors against what the standard deviations say, in every second scene
   */
  private static List<NormalisedErrors[]> scenes(double constantShare, double scale, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    List<NormalisedErrors[]> scenes = new ArrayList<>();
    double likeness = 0.9;
    for (int scene = 0; scene < SCENES; scene++) {
      NormalisedErrors[] wings = {new NormalisedErrors(), new NormalisedErrors()};
      double constant = Math.sqrt(constantShare) * random.nextGaussian();
      double size = scene % 2 == 0 ? 1 : scale;
      for (int wing = 0; wing < 2; wing++) {
        double following = random.nextGaussian();
        for (int tick = 0; tick < 600; tick++) {
          following =
              likeness * following + Math.sqrt(1 - likeness * likeness) * random.nextGaussian();
          double error =
              (wing == 0 ? constant : -constant) + Math.sqrt(1 - constantShare) * following;
          wings[wing].add(size * error);
        }
      }
      scenes.add(wings);
    }
    return scenes;
  }

  private static double shareInside(List<NormalisedErrors[]> scenes) {
    return NeesBand.of(scenes).count(scenes) / (double) SCENES;
  }

  @Test
  void correctDeviationsLieInTheBandIn95PercentOfScenesWhateverTheErrorCorrelation() {
    for (double constantShare : new double[] {0, 0.3, 0.7, 1}) {
      assertEquals(0.95, shareInside(scenes(constantShare, 1, 1)), 0.04, "share " + constantShare);
    }
  }

  @Test
  void incorrectDeviationsLieOutsideTheBand() {
    assertTrue(shareInside(scenes(0, 1.5, 2)) < 0.6, "too small");
    assertTrue(shareInside(scenes(0, 0.6, 3)) < 0.6, "too large");
    assertTrue(shareInside(scenes(0.3, 2, 4)) < 0.85, "too small beside constant errors");
  }

  @Test
  void bandWidensWithTheConstantShareOfTheError() {
    NeesBand following = NeesBand.of(scenes(0, 1, 5));
    NeesBand constant = NeesBand.of(scenes(1, 1, 5));
    assertTrue(following.min() > 0.7 && following.max() < 1.35, following::toString);
    // chi squared of one degree of freedom: 0.001 to 5.02
    assertEquals(0.001, constant.min(), 0.03);
    assertEquals(5.02, constant.max(), 0.8);
  }
}
