package haltere.filters.wing.internal.stroke;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class CameraLatencyTest {
  /** Radians a second in mid stroke, of a wing of 65 degrees that beats 100 and 350 times. */
  private static final double SLOW = 1.13 * 2 * Math.PI * 100;

  private static final double FAST = 1.13 * 2 * Math.PI * 350;

  @Test
  void pixelWithoutALagHasOnlyTheConstantDelay() {
    assertEquals(60e-6, CameraLatency.seconds(60, 0, SLOW), 1e-12);
    assertEquals(25e-6, CameraLatency.seconds(25, -5e-6, FAST), 1e-12);
  }

  @Test
  void slowPixelRespondsBeforeTheWingHasPassed() {
    double over = 0.05 * Math.sqrt(2) / SLOW;
    double added = CameraLatency.seconds(0, 300e-6, SLOW);
    assertTrue(added > 0.3 * over && added < 0.4 * over);
  }

  @Test
  void fastWingDelaysOnEventsOfFastPixels() {
    // as on simulated ideal pixels that are blind for 30 us after an event
    assertEquals(60e-6, CameraLatency.seconds(60, 10e-6, FAST), 1e-12);
    assertTrue(CameraLatency.seconds(60, 10e-6, SLOW) > 70e-6);
  }
}
