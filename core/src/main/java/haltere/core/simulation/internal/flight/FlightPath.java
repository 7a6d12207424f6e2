package haltere.core.simulation.internal.flight;

import haltere.core.simulation.internal.sensor.SeededRandom;
import haltere.core.simulation.internal.sensor.SlowProcess;

/**
 * The flight of a body along a wandering circle, as a pure function of time. Its axis deviates from
 * the course by a slip angle, which changes in saccades, and by a pitch.
 *
 * <p>Thread rule: immutable.
 */
final class FlightPath {
  private static final double STEP_S = 1e-4;

  private final FlightBodySettings body;
  private final long seed;
  private final double radius;
  private final double turnsRadS;
  private final double startRad;
  private final SlowProcess radial;
  private final SlowProcess around;
  private final SlowProcess height;
  private final SlowProcess pitch;

  FlightPath(FlightBodySettings body, double roomM, long seed) {
    this.body = body;
    this.seed = seed;
    SeededRandom random = new SeededRandom(seed, "flight");
    radius = 0.55 * roomM;
    turnsRadS = (random.nextDouble() < 0.5 ? -1 : 1) * body.speedMS() / radius;
    startRad = random.between(0, 2 * Math.PI);
    double fastest = Math.max(0.02, 0.15 * body.speedMS() / radius);
    radial = new SlowProcess(random, 0.08 * roomM, 0.3 * fastest, fastest);
    around = new SlowProcess(random, 0.15, 0.3 * fastest, fastest);
    height = new SlowProcess(random, 0.15 * roomM, 0.3 * fastest, fastest);
    pitch = new SlowProcess(random, Math.toRadians(8), 0.1, 0.7);
  }

  /** Position in metres. */
  void position(double seconds, double[] out) {
    double r = radius + radial.at(seconds);
    double angle = startRad + turnsRadS * seconds + around.at(seconds);
    out[0] = r * StrictMath.cos(angle);
    out[1] = r * StrictMath.sin(angle);
    out[2] = height.at(seconds);
  }

  /** Velocity in metres a second. */
  void velocity(double seconds, double[] out) {
    double[] before = new double[3];
    position(seconds - STEP_S, before);
    position(seconds + STEP_S, out);
    for (int k = 0; k < 3; k++) {
      out[k] = (out[k] - before[k]) / (2 * STEP_S);
    }
  }

  /** Axis, tail to head, a unit vector. */
  void axis(double seconds, double[] out) {
    velocity(seconds, out);
    double heading = StrictMath.atan2(out[1], out[0]) + slip(seconds);
    double up = Math.toRadians(body.pitchDeg()) + pitch.at(seconds);
    out[0] = StrictMath.cos(up) * StrictMath.cos(heading);
    out[1] = StrictMath.cos(up) * StrictMath.sin(heading);
    out[2] = StrictMath.sin(up);
  }

  /** Slip angle between axis and course: constant except for one saccade per interval. */
  private double slip(double seconds) {
    if (body.saccadesPerS() == 0) {
      return 0;
    }
    double stretch = 1 / body.saccadesPerS();
    long number = (long) Math.floor(seconds / stretch);
    double from = target(number - 1);
    double to = target(number);
    double spare = Math.max(0, stretch - body.saccadeS());
    double begin =
        number * stretch + spare * SeededRandom.of(seed, "saccade time", number).nextDouble();
    double share = Math.min(1, Math.max(0, (seconds - begin) / body.saccadeS()));
    return from + (to - from) * share * share * share * (10 + share * (6 * share - 15));
  }

  private double target(long number) {
    double maxRad = Math.toRadians(body.saccadeDeg()) / 2;
    return SeededRandom.of(seed, "saccade", number).between(-maxRad, maxRad);
  }
}
