package haltere.filters.wing.internal.stroke;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class StrokeEkfTest {
  private static final double[] STATE = {
    1.7, 1.1, 0.8, 1250, 0.03, 50e-6, 20, 0.05, -0.03, 0.01, 0.02
  };

  private static StrokeEkf filter(double[] state) {
    StrokeEkf filter = new StrokeEkf(3);
    double[] sd = new double[state.length];
    java.util.Arrays.fill(sd, 1);
    filter.launch(state, sd);
    return filter;
  }

  /** Measurement equation of an event of an edge, written out. */
  private static double measured(double[] x, int edge) {
    double phase = edge < 0 ? x[2] - x[3] * x[5] : x[2];
    double angle = x[0] + x[1] * Math.sin(phase);
    double slope = x[1] * Math.cos(phase);
    for (int k = 2; k <= 3; k++) {
      double c = x[3 + 2 * k];
      double s = x[4 + 2 * k];
      angle += c * Math.cos(k * phase) + s * Math.sin(k * phase);
      slope += k * (s * Math.cos(k * phase) - c * Math.sin(k * phase));
    }
    return angle + edge * Math.signum(slope) * x[4];
  }

  @Test
  void derivativesMatchTheMeasurement() {
    for (int edge : new int[] {1, -1, 0}) {
      for (int i = 0; i < STATE.length; i++) {
        StrokeEkf filter = new StrokeEkf(3);
        double[] sd = new double[STATE.length];
        sd[i] = 1;
        filter.launch(STATE, sd);
        double back = edge < 0 ? STATE[3] * STATE[5] : 0;
        filter.look(Math.cos(STATE[2] - back), Math.sin(STATE[2] - back), edge);
        double step = 1e-6 * Math.max(1e-2, Math.abs(STATE[i]));
        double[] more = STATE.clone();
        double[] less = STATE.clone();
        more[i] += step;
        less[i] -= step;
        double slope = (measured(more, edge) - measured(less, edge)) / (2 * step);
        // with one uncertain entry of variance 1, the expected variance is the derivative squared
        assertEquals(
            Math.abs(slope), Math.sqrt(filter.expectedVariance()), 1e-5 * (1 + Math.abs(slope)));
      }
    }
  }

  @Test
  void smallRotationsOfThePhaseAddUp() {
    StrokeEkf filter = filter(STATE);
    double phase = STATE[2];
    SplittableRandom random = new SplittableRandom(1);
    for (int i = 0; i < 1_000_000; i++) {
      double angle = random.nextDouble(-0.01, 0.03);
      phase += angle;
      filter.turn(angle);
    }
    assertEquals(Math.cos(phase), filter.cos, 1e-8);
    assertEquals(Math.sin(phase), filter.sin, 1e-8);
  }

  @Test
  void stateIsEstimatedOnModelDataWithSymmetricCovariance() {
    SplittableRandom random = new SplittableRandom(2);
    double[] truth = STATE.clone();
    truth[6] = 0;
    double[] start = truth.clone();
    start[0] += 0.05;
    start[1] -= 0.05;
    start[2] += 0.1;
    start[3] *= 1.02;
    StrokeEkf filter = new StrokeEkf(3);
    filter.launch(start, StrokeSeed.sd(3));
    double[] density = new double[filter.size];
    density[StrokeEkf.OMEGA] = 100;
    for (int i = 0; i < 20_000; i++) {
      double dtS = 10e-6;
      truth[2] += truth[3] * dtS;
      filter.turn(filter.x[StrokeEkf.OMEGA] * dtS);
      filter.predictCovariance(dtS, density);
      int edge = random.nextBoolean() ? 1 : -1;
      double c = filter.cos;
      double s = filter.sin;
      if (edge < 0) {
        double behind = c * filter.lagCos + s * filter.lagSin;
        s = s * filter.lagCos - c * filter.lagSin;
        c = behind;
      }
      double ahead = filter.slope(c, s) >= 0 ? edge : -edge;
      double y =
          measured(truth, edge)
              + 0.03 * random.nextGaussian()
              - filter.angle(c, s)
              - ahead * filter.x[StrokeEkf.WIDTH];
      filter.mark();
      filter.look(c, s, edge);
      filter.update(y, 0.03 * 0.03);
      filter.settle();
    }
    assertEquals(truth[0], filter.x[0], 0.01);
    assertEquals(truth[1], filter.x[1], 0.01);
    assertEquals(truth[3], filter.x[3], 3);
    assertEquals(truth[4], filter.x[4], 0.005);
    assertEquals(truth[5], filter.x[5], 10e-6);
    for (int i = 0; i < filter.size; i++) {
      assertTrue(filter.belief.covariance(i, i) > 0);
      for (int j = 0; j < i; j++) {
        double scale = Math.sqrt(filter.belief.covariance(i, i) * filter.belief.covariance(j, j));
        assertEquals(filter.belief.covariance(i, j), filter.belief.covariance(j, i), 1e-6 * scale);
      }
    }
  }

  @Test
  void lagIsWeightedByTheVariancesOfBothWings() {
    StrokeEkf[] wings = {filter(STATE), filter(STATE)};
    wings[0].set(StrokeEkf.LAG, 10e-6);
    wings[1].set(StrokeEkf.LAG, 50e-6);
    assertEquals(30e-6, CameraLatency.lagS(wings[0], wings[1]), 1e-12);
    wings[1].belief.edit(StrokeEkf.LAG, StrokeEkf.LAG, 1e-12);
    assertEquals(50e-6, CameraLatency.lagS(wings[0], wings[1]), 1e-9);
    assertEquals(50e-6, CameraLatency.lagS(wings[1], wings[0]), 1e-9);
    assertEquals(10e-6, CameraLatency.lagS(wings[0], null));
  }

  @Test
  void fastAngleMatchesTheExactAngle() {
    SplittableRandom random = new SplittableRandom(3);
    for (int i = 0; i < 100_000; i++) {
      double x = random.nextDouble(-50, 50);
      double y = random.nextDouble(-50, 50);
      assertEquals(Math.atan2(y, x), FastAngle.of(y, x), 3e-8);
    }
    assertEquals(0, FastAngle.of(0, 0));
    assertEquals(Math.PI, FastAngle.of(0, -1), 1e-12);
    assertEquals(Math.PI / 2, FastAngle.of(1, 0), 1e-12);
  }

  @Test
  void slopeIsTheDerivativeOfTheAngle() {
    StrokeEkf filter = new StrokeEkf(4);
    double[] state = new double[filter.size];
    state[StrokeEkf.CENTRE] = 1.7;
    state[StrokeEkf.AMPLITUDE] = 1.1;
    for (int i = StrokeEkf.SERIES; i < filter.size; i++) {
      state[i] = 0.02 * (i - 5);
    }
    filter.launch(state, new double[filter.size]);
    for (double phase = 0; phase < 6; phase += 0.7) {
      double step = 1e-5;
      double more = filter.angle(Math.cos(phase + step), Math.sin(phase + step));
      double less = filter.angle(Math.cos(phase - step), Math.sin(phase - step));
      double slope = filter.slope(Math.cos(phase), Math.sin(phase));
      assertEquals((more - less) / (2 * step), slope, 1e-8);
      assertEquals(slope, filter.slopeThere);
    }
  }
}
