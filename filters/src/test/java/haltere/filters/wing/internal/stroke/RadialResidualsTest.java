package haltere.filters.wing.internal.stroke;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;

class RadialResidualsTest {
  private static final double LENGTH_PX = 40;
  private static final double SPEED = 1500;
  private static final double NOISE_RAD = 0.02;
  private static final double HALF_APART_S = 100e-6;

  private RadialResiduals radial;
  private boolean isSpread;

  /** Events of both edges, apart by a time that depends on the share of the length. */
  private void look(int events, double trailingShare, DoubleUnaryOperator apartS, double bendS) {
    SplittableRandom random = new SplittableRandom(7);
    radial = new RadialResiduals(LENGTH_PX * LENGTH_PX);
    for (int i = 0; i < events; i++) {
      double share = Math.sqrt(random.nextDouble());
      double square = share * share * LENGTH_PX * LENGTH_PX;
      for (int edge = 0; edge < 2; edge++) {
        if (edge == 0 || random.nextDouble() < trailingShare) {
          double half = (edge == 0 ? 1 : -1) * (apartS.applyAsDouble(share) - HALF_APART_S);
          double bend = bendS * (share - 2.0 / 3);
          double noise = NOISE_RAD * random.nextDouble(-Math.sqrt(3), Math.sqrt(3));
          radial.add(edge, square, (half + bend) * SPEED + noise, SPEED);
        }
      }
    }
    double variance = NOISE_RAD * NOISE_RAD;
    radial.update(1e-3, HALF_APART_S, new double[] {variance, variance}, isSpread);
  }

  @Test
  void edgesConvergingTowardsTheTipIndicateAChord() {
    look(4000, 1, share -> 300e-6 * (1 - share), 0);
    assertTrue(radial.chordShare > 0.8, "" + radial.chordShare);
    assertEquals(0, radial.bendVariance, 1e-11);
  }

  @Test
  void edgesAtConstantAngleIndicateALag() {
    look(4000, 1, share -> HALF_APART_S, 0);
    assertTrue(radial.chordShare < 0.05, "" + radial.chordShare);
  }

  @Test
  void fewEventsGiveNoChord() {
    look(20, 1, share -> HALF_APART_S, 0);
    assertTrue(radial.chordShare < 0.2, "" + radial.chordShare);
  }

  @Test
  void curvedMiddleLineIsDetected() {
    double bendS = 200e-6;
    look(4000, 1, share -> HALF_APART_S, bendS);
    // the share of the length has a variance of 1/18 over a disc
    assertEquals(bendS * bendS / 18, radial.bendVariance, 0.2 * bendS * bendS / 18);
  }

  @Test
  void passagesWithOneRespondingEdgeAreCounted() {
    look(2000, 1, share -> HALF_APART_S, 0);
    assertEquals(1, radial.answeredShare, 1e-9);
    look(2000, 0.75, share -> HALF_APART_S, 0);
    assertEquals(0.5, radial.answeredShare, 0.05);
    look(2000, 0.3, share -> HALF_APART_S, 0);
    assertEquals(0, radial.answeredShare, 1e-9);
  }

  @Test
  void wideWingIsDetectedByRadiusOrTimes() {
    look(4000, 1, share -> HALF_APART_S, 0);
    assertEquals(0, radial.wideShare);
    look(4000, 1, share -> 300e-6 * (1 - share), 0);
    assertTrue(radial.wideShare > 0, "" + radial.wideShare);
    isSpread = true;
    look(4000, 1, share -> HALF_APART_S, 0);
    assertTrue(radial.wideShare > 0, "" + radial.wideShare);
  }

  @Test
  void timesOfANarrowWingScatterLessThanItsPassage() {
    double fullSpeed = 1700;
    assertFalse(CameraLatency.isWide(15e-6, fullSpeed));
    assertTrue(CameraLatency.isWide(60e-6, fullSpeed));
  }

  @Test
  void littleScatterOfTimesIndicatesFastPixels() {
    assertTrue(CameraLatency.fastShare(200e-6, 1e-6) > 0.99);
    assertTrue(CameraLatency.fastShare(200e-6, 80e-6) < 0.05);
    assertEquals(0, CameraLatency.fastShare(-10e-6, 1e-6));
  }
}
