package haltere.testing.wings;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.simulation.internal.fly.RenderedFlySceneSettings;
import org.junit.jupiter.api.Test;

/** Random flies for the evaluation of the wing tracker. */
class RenderedFliesTest {
  @Test
  void everySeedGivesAValidFlyWithAMembraneAboveThePixelThreshold() {
    for (long seed = 0; seed < 1000; seed++) {
      RenderedFlySceneSettings scene = RenderedFlies.random(seed);
      double contrast = -Math.log(scene.fly().wing().transmission());

      assertTrue(contrast >= 1.19 * scene.pixel().threshold(), "seed " + seed);
    }
  }

  @Test
  void sameSeedGivesTheSameFly() {
    assertEquals(RenderedFlies.random(5), RenderedFlies.random(5));
  }
}
