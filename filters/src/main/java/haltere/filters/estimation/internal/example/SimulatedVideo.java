package haltere.filters.estimation.internal.example;

import haltere.core.simulation.internal.sensor.SeededRandom;
import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;

/**
 * Measurements as in Casper (2012): a video of 240.386 frames a second and 240 rows, in which the
 * displacement is read off each frame to whole rows. The same seed gives the same measurements.
 */
public final class SimulatedVideo {
  /** Acceleration of the falling weight. */
  static final double GRAVITY_M_S2 = 9.81;

  /** Damping ratio ζ of the weight on a spring, as Casper (2012) found it. */
  static final double DAMPING = 0.07;

  /** Undamped angular frequency of the weight on a spring, as Casper (2012) found it. */
  static final double FREQUENCY_RAD_S = 4.37;

  private static final double FRAME_S = 1 / 240.386;
  private static final int ROWS_PX = 240;

  private SimulatedVideo() {}

  /**
   * A weight that is released with a small velocity and falls for 0.4 s, +x downwards, through most
   * of a picture of 1 m.
   *
   * @param seed of the velocity (standard deviation 0.3 m/s) and of the measurement noise (4 mm)
   * @return 97 measurements
   */
  public static MeasurementSeries fallingWeight(long seed) {
    double v0 = fallingWeightVelocity(seed);
    return video(seed, 97, 1, 0.004, t -> v0 * t + GRAVITY_M_S2 * t * t / 2);
  }

  /** Initial velocity in m/s of the falling weight of a seed. */
  static double fallingWeightVelocity(long seed) {
    return 0.3 * new SeededRandom(seed, "velocity").gaussian();
  }

  /**
   * A weight on a spring that is pulled down and released at time 0, for 5 s, +x upwards, in a
   * picture of 30 cm.
   *
   * @param seed of the displacement (10 cm, standard deviation 1 cm) and of the measurement noise
   *     (1 mm)
   * @return 1,202 measurements
   */
  public static MeasurementSeries oscillator(long seed) {
    return oscillator(seed, releaseM(seed), 0);
  }

  /** Initial displacement in metres of the weight on a spring of a seed. */
  static double releaseM(long seed) {
    return -0.1 + 0.01 * new SeededRandom(seed, "displacement").gaussian();
  }

  /** A weight on a spring with any initial state. */
  static MeasurementSeries oscillator(long seed, double s0M, double v0MS) {
    return video(
        seed, 1202, 0.3, 0.001, t -> Oscillations.exact(s0M, v0MS, DAMPING, FREQUENCY_RAD_S, t)[0]);
  }

  private static MeasurementSeries video(
      long seed, int frames, double pictureM, double noiseM, DoubleUnaryOperator displacement) {
    SeededRandom random = new SeededRandom(seed, "reading");
    double rowM = pictureM / ROWS_PX;
    List<Measurement> measurements = new ArrayList<>();
    for (int k = 0; k < frames; k++) {
      double read = displacement.applyAsDouble(k * FRAME_S) + noiseM * random.gaussian();
      measurements.add(new Measurement(k * FRAME_S, Math.rint(read / rowM) * rowM, Double.NaN));
    }
    return new MeasurementSeries(measurements);
  }
}
