package haltere.filters.object;

/**
 * Whether a component moves, rests or is gone: a hidden Markov chain, filtered forward (Rabiner,
 * Proceedings of the IEEE 77, 1989, eq. 19–20), in the role of the existence of Mušicki, Evans and
 * Stankovic (IEEE TAC 39, 1994). Only a moving component makes events. Its rate is not known well,
 * for it varies with speed and direction: the likelihood is the mean over three dimmings of it.
 */
final class Presence {
  /** Dimmings of the rate: as expected, and down to a fifth of it. */
  static final double[] DIMMINGS = {1, Math.sqrt(0.2), 0.2};

  /** Rate at which a moving component stops, Hz: people and animals pause about every second. */
  static final double STOP_HZ = 1;

  /** Rate at which a moving component vanishes inside the picture, Hz. */
  static final double VANISH_HZ = 0.1;

  /** Rate at which one vanishes that is wholly outside of the picture for a time, Hz. */
  private static final double LEAVE_HZ = 1 / ClutterMap.BIRTH_S;

  /** Rate at which a resting component is given up, Hz. */
  private static final double FORGET_HZ = 0.5;

  /** Probability that what was just seen to be born moves: one of ten is a flicker. */
  private static final double NEWBORN = 0.9;

  private double moving;
  private double resting;
  private double gone;

  /** What was just seen to be born moves, or is a flicker. */
  void begin() {
    set(NEWBORN, 0, 1 - NEWBORN);
  }

  void set(double moving, double resting, double gone) {
    this.moving = moving;
    this.resting = resting;
    this.gone = gone;
  }

  void set(Presence other) {
    set(other.moving, other.resting, other.gone);
  }

  double moving() {
    return moving;
  }

  /** Probability to be moving in the next tick, if it does not vanish. */
  double movingNext() {
    return moving + (resting - moving) * STOP_HZ * ObjectTracker.TICK_S;
  }

  double gone() {
    return gone;
  }

  boolean isMoving() {
    return moving >= 0.5;
  }

  /**
   * A tick of length {@link ObjectTracker#TICK_S}.
   *
   * @param logs for each dimming, the log likelihood ratio of the tick's events
   * @param expected events expected of the component in the tick
   * @param inside share of its extent that is within the picture
   */
  void update(double[] logs, double expected, double inside) {
    double dt = ObjectTracker.TICK_S;
    double vanish = (VANISH_HZ + LEAVE_HZ * (1 - inside) * (1 - inside)) * dt;
    double stop = STOP_HZ * dt;
    double forget = FORGET_HZ * dt;
    double nextMoving = moving * (1 - stop - vanish) + resting * stop;
    double nextResting = moving * stop + resting * (1 - stop - forget);
    double nextGone = gone + moving * vanish + resting * forget;
    double best = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < DIMMINGS.length; i++) {
      best = Math.max(best, logs[i] - DIMMINGS[i] * expected);
    }
    double sum = 0;
    for (int i = 0; i < DIMMINGS.length; i++) {
      sum += Math.exp(logs[i] - DIMMINGS[i] * expected - best);
    }
    double log = best + Math.log(sum / DIMMINGS.length);
    // scaled by the larger likelihood, so that nothing overflows
    double silent = Math.exp(Math.min(0, -log));
    nextMoving *= Math.exp(Math.min(0, log));
    nextResting *= silent;
    nextGone *= silent;
    double all = nextMoving + nextResting + nextGone;
    set(nextMoving / all, nextResting / all, nextGone / all);
  }
}
