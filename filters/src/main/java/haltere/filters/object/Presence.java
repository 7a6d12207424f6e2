package haltere.filters.object;

/**
 * Whether a component moves, rests or is gone: a hidden Markov chain, filtered forward (Rabiner,
 * Proceedings of the IEEE 77, 1989, eq. 19–20), instead of the existence of Mušicki, Evans and
 * Stankovic (IEEE TAC 39, 1994). Only a moving component makes events. Its rate varies with speed
 * and direction: the likelihood is the mean over three attenuations.
 */
final class Presence {
  /** Attenuations of the rate, down to a fifth. */
  static final double[] ATTENUATIONS = {1, Math.sqrt(0.2), 0.2};

  /** Rate at which a moving component stops, Hz: people and animals pause about every second. */
  static final double STOP_HZ = 1;

  /** Rate at which a moving component vanishes inside the picture, Hz. */
  static final double VANISH_HZ = 0.1;

  /** Rate at which a component outside of the picture vanishes, Hz. */
  private static final double LEAVE_HZ = 1 / ClutterMap.BIRTH_S;

  /** Rate from resting to gone, Hz. */
  private static final double FORGET_HZ = 0.5;

  /** Probability that a birth is a moving object: one of ten is a flicker. */
  private static final double NEWBORN = 0.9;

  private double moving;
  private double resting;
  private double gone;

  /** Sets the probabilities of a birth. */
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

  /** Probability of moving in the next tick, if it does not vanish. */
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
   * @param logs log likelihood ratio of the events of the tick, for each attenuation
   * @param expected expected events of the component in the tick
   * @param inside share of its extent within the picture
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
    for (int i = 0; i < ATTENUATIONS.length; i++) {
      best = Math.max(best, logs[i] - ATTENUATIONS[i] * expected);
    }
    double sum = 0;
    for (int i = 0; i < ATTENUATIONS.length; i++) {
      sum += Math.exp(logs[i] - ATTENUATIONS[i] * expected - best);
    }
    double log = best + Math.log(sum / ATTENUATIONS.length);
    // scaled by the larger likelihood, against overflow
    double silent = Math.exp(Math.min(0, -log));
    nextMoving *= Math.exp(Math.min(0, log));
    nextResting *= silent;
    nextGone *= silent;
    double all = nextMoving + nextResting + nextGone;
    set(nextMoving / all, nextResting / all, nextGone / all);
  }
}
