package haltere.filters.estimation;

import haltere.filters.estimation.motion.DampedOscillator;
import haltere.filters.estimation.motion.WhiteJerk;
import java.util.ArrayList;
import java.util.List;
import org.ejml.data.DMatrixRMaj;

/** The two worked examples of {@code docs/estimation.md}, on simulated video. */
final class WorkedExamples {
  /** Frames per second of the report's camera; 240 nominally. */
  static final double FRAMES_PER_SECOND = 240.386;

  /** Seed of the fall that the documentation shows; one in three ends outside one deviation. */
  static final long SHOWN_FALL = 2;

  static final double GRAVITY = 9.81;

  /** Standard deviation of a position read off a frame. */
  static final double FALL_NOISE_M = 0.004;

  static final double SPRING_NOISE_CM = 0.1;

  /**
   * What the report must have taken for the noise of a position: with it the frequency is known to
   * about 1 rad/s after a second, as the report says.
   */
  static final double REPORTED_NOISE_CM = 27;

  static final double DAMPING = 0.07;

  /** Root of k/m with k = 2.562 N/m and m = 0.138 kg, in rad/s. */
  static final double FREQUENCY = 4.309;

  private static final int FALL_FRAMES = 97;
  private static final int SPRING_FRAMES = 1202;
  private static final double FRAME_S = 1 / FRAMES_PER_SECOND;

  private WorkedExamples() {}

  /** A weight let go at a small unknown speed; estimates of (s, v, a) in metres, one per frame. */
  static List<Estimate> fallingWeight(long seed) {
    return fallingWeight(seed, new ArrayList<>());
  }

  static List<Estimate> fallingWeight(long seed, List<FilterStep> steps) {
    Draws draws = new Draws(seed);
    double v0 = draws.normal(0.3);
    KalmanFilter filter =
        new KalmanFilter(
            new WhiteJerk(1, 1e-3), Matrices.column(0, 0, 2), Matrices.diagonal(1, 25, 100));
    filter.observe(steps::add);
    LinearMeasurement position = LinearMeasurement.ofEntries(3, FALL_NOISE_M * FALL_NOISE_M, 0);
    List<Estimate> estimates = new ArrayList<>();
    for (int k = 0; k < FALL_FRAMES; k++) {
      double t = k * FRAME_S;
      if (k > 0) {
        filter.predict(FRAME_S);
      }
      filter.update(position, v0 * t + GRAVITY * t * t / 2 + draws.normal(FALL_NOISE_M));
      estimates.add(filter.estimate());
    }
    return estimates;
  }

  /** What the weight of a seed truly does at the last frame: (s, v, a). */
  static double[] fallingWeightTruth(long seed) {
    double v0 = new Draws(seed).normal(0.3);
    double t = (FALL_FRAMES - 1) * FRAME_S;
    return new double[] {v0 * t + GRAVITY * t * t / 2, v0 + GRAVITY * t, GRAVITY};
  }

  /** A weight on a spring, pushed through its rest at about 60 cm/s; positions in cm. */
  static final class Spring {
    final double[] measured = new double[SPRING_FRAMES];
    final double[] truth;

    Spring(long seed) {
      Draws draws = new Draws(seed);
      double v0 = 60 + draws.normal(10);
      double[] at = new double[2];
      for (int k = 0; k < SPRING_FRAMES; k++) {
        at = Oscillations.exact(0, v0, DAMPING, FREQUENCY, k * FRAME_S);
        measured[k] = at[0] + draws.normal(SPRING_NOISE_CM);
      }
      truth = new double[] {at[0], at[1], DAMPING, FREQUENCY};
    }

    /**
     * First pass, with the report's start: next to nothing is known, and a measurement is believed
     * as little as the report's standard deviation of the frequency after a second tells.
     */
    List<Estimate> firstPass(double frequency) {
      return fromNextToNothing(frequency, REPORTED_NOISE_CM);
    }

    /** From the report's start, with measurements that are believed as they deserve. */
    List<Estimate> onlyPass() {
      return fromNextToNothing(3, SPRING_NOISE_CM);
    }

    private List<Estimate> fromNextToNothing(double frequency, double noiseCm) {
      return pass(
          Matrices.column(0, 60, 0.1, frequency), Matrices.diagonal(1e4, 1e6, 100, 1000), noiseCm);
    }

    /**
     * Second pass, linearised where the first one ended. What it takes over is kept so vague
     * (damping ± 0.05, frequency ± 0.3 rad/s) that the data, used twice, count once.
     */
    List<Estimate> secondPass(List<Estimate> first) {
      Estimate end = first.get(first.size() - 1);
      // (ζ, ω) and (−ζ, −ω) are one and the same motion.
      double sign = Math.signum(end.value(DampedOscillator.FREQUENCY));
      return pass(
          Matrices.column(
              0,
              60,
              sign * end.value(DampedOscillator.DAMPING),
              sign * end.value(DampedOscillator.FREQUENCY)),
          Matrices.diagonal(1, 400, 0.05 * 0.05, 0.3 * 0.3),
          SPRING_NOISE_CM);
    }

    private List<Estimate> pass(DMatrixRMaj x, DMatrixRMaj p, double noiseCm) {
      KalmanFilter filter = new KalmanFilter(new DampedOscillator(0, 0, 0), x, p);
      LinearMeasurement position = LinearMeasurement.ofEntries(4, noiseCm * noiseCm, 0);
      List<Estimate> estimates = new ArrayList<>();
      for (int k = 0; k < SPRING_FRAMES; k++) {
        if (k > 0) {
          filter.predict(FRAME_S);
        }
        filter.update(position, measured[k]);
        estimates.add(filter.estimate());
      }
      return estimates;
    }
  }
}
