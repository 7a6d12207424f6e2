package haltere.filters.track.motion;

import haltere.filters.track.MotionModel;
import haltere.filters.track.MotionSettings;
import haltere.filters.track.ProcessNoise;

/** The numbers of {@link MotionModes}, taken from settings once. Thread rule: immutable. */
public final class MotionNoise {
  /** A rate of turning that is unknown: 6 rad/s, about a second for a circle. */
  private static final double TURN_RATE_VARIANCE = 36;

  /** Share of a track's way of moving on a road that brakes or changes lanes: m²/s³. */
  private static final double ROAD_AGILE_FACTOR = 300;

  private static final double ROAD_LAUNCH_SPEED_M_S = 40;

  /** Vehicles brake with up to 8 m/s², and mostly with half of that, for a second or two. */
  private static final AlongAcceleration BRAKING = new AlongAcceleration(3, 2);

  /** How long a target does anything, as a share of how long it goes on in another way. */
  private static final double AGILE_STAY = 0.1;

  /** The same on a road, where braking takes seconds. */
  private static final double ROAD_AGILE_STAY = 1;

  /** Share of the changes between more than two modes that lead to doing anything. */
  private static final double AGILE_ENTRY = 0.1;

  /** Times over those that a mode lasts up to which a series is as good as an exponential. */
  private static final double SHORT = 0.05;

  /**
   * Three modes are mixed after this time at the earliest, so at every third update where these
   * come as often as they can: with seconds between changes that is as good, and mixing takes as
   * long as half of the rest.
   */
  private static final double MIXED_EVERY_S = 0.025;

  private final boolean perStep;
  private final double[] acceleration;
  private final boolean[] turns;
  private final double turn;
  private final double launchSpeed;
  private final double agileStay;
  private final double stayS;

  /** What the last mode does along a road, or null. */
  private final AlongAcceleration along;

  private MotionNoise(
      MotionSettings settings,
      double[] acceleration,
      boolean[] turns,
      double launchSpeed,
      double agileStay,
      AlongAcceleration along) {
    perStep = settings.noise() == ProcessNoise.PER_UPDATE;
    turn = settings.turnVariance();
    stayS = settings.meanStayS();
    this.acceleration = acceleration;
    this.turns = turns;
    this.launchSpeed = launchSpeed;
    this.agileStay = agileStay;
    this.along = along;
  }

  /**
   * Of targets in pixels.
   *
   * @param settings how they move, densities in px²/s³
   * @return its numbers
   */
  public static MotionNoise inPixels(MotionSettings settings) {
    double launch = settings.launchSpeedPxS();
    if (settings.model() == MotionModel.STRAIGHT) {
      return new MotionNoise(
          settings,
          new double[] {settings.minProcessVariance()},
          new boolean[1],
          launch,
          AGILE_STAY,
          null);
    }
    return new MotionNoise(
        settings,
        new double[] {
          settings.minProcessVariance(), settings.turningVariance(), settings.agileVariance()
        },
        new boolean[] {false, true, false},
        launch,
        AGILE_STAY,
        null);
  }

  /**
   * Of vehicles in metres: they go straight on, or brake and steer.
   *
   * @param settings which modes there are, and how long each lasts
   * @param processVariance density of white acceleration, m²/s³
   * @return its numbers
   */
  public static MotionNoise onRoad(MotionSettings settings, double processVariance) {
    double[] one = {processVariance};
    double[] two = {processVariance, ROAD_AGILE_FACTOR * processVariance};
    boolean brakes = settings.model() != MotionModel.STRAIGHT;
    double[] densities = brakes ? two : one;
    return new MotionNoise(
        settings,
        densities,
        new boolean[densities.length],
        ROAD_LAUNCH_SPEED_M_S,
        ROAD_AGILE_STAY,
        brakes && settings.noise() != ProcessNoise.PER_UPDATE ? BRAKING : null);
  }

  int modes() {
    return acceleration.length;
  }

  boolean perStep() {
    return perStep;
  }

  boolean turns(int mode) {
    return turns[mode];
  }

  double acceleration(int mode) {
    return acceleration[mode];
  }

  double turn() {
    return turn;
  }

  /** How a mode accelerates along a road, or null if it does not. */
  AlongAcceleration along(int mode) {
    return mode == acceleration.length - 1 ? along : null;
  }

  /** Variance of the fifth state, a rate, as long as nothing is known of it; 0 for none. */
  double rateVariance(int mode) {
    if (turns[mode]) {
      return TURN_RATE_VARIANCE;
    }
    AlongAcceleration accelerates = along(mode);
    return accelerates == null ? 0 : accelerates.variance();
  }

  /** Standard deviation of each velocity of a new target. */
  double launchSpeed() {
    return launchSpeed;
  }

  double launchVelocityVariance() {
    return launchSpeed * launchSpeed;
  }

  /** The time after which modes are mixed, at the earliest. */
  double mixedEveryS() {
    return modes() > 2 ? MIXED_EVERY_S : 0;
  }

  /** Probability that a target has left a mode after a time. */
  double leave(int mode, double dtS) {
    boolean agile = mode > 0 && mode == acceleration.length - 1;
    double stays = dtS / (agile ? stayS * agileStay : stayS);
    // The approximation of Padé of order 2, 2, within 1e-9 up to there.
    return stays < SHORT ? stays / (1 + stays / 2 + stays * stays / 12) : 1 - Math.exp(-stays);
  }

  /**
   * Share of the targets that leave a mode that goes on in a certain other one. The last of several
   * modes, in which anything goes, is rarely entered.
   */
  double share(int from, int to) {
    int last = acceleration.length - 1;
    if (from == last) {
      return 1.0 / last;
    }
    double agile = last == 1 ? 1 : AGILE_ENTRY;
    return to == last ? agile : (1 - agile) / (last - 1);
  }
}
