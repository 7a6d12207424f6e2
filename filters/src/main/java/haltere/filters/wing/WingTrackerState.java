package haltere.filters.wing;

import haltere.core.sink.Column;

/**
 * A step of the search for the fly, or a change of what is tracked.
 *
 * @param timeUs time on the clock of the events, microseconds
 * @param phase what the tracker does from now on, or has just done
 * @param events events that it was done with
 * @param frequencyHz beat frequency as known then, hertz; NaN if not yet
 * @param centreX body centre as known then, pixels; NaN if not yet
 * @param centreY body centre as known then, pixels; NaN if not yet
 * @param headingRad heading as known then; NaN if not yet
 * @param sizePx size as known then, pixels; NaN if not yet
 * @param confidence of head and tail as known then, 0 to 1; NaN if not yet
 */
public record WingTrackerState(
    @Column("t_us") long timeUs,
    Phase phase,
    int events,
    @Column(decimals = 3) double frequencyHz,
    @Column(decimals = 3) double centreX,
    @Column(decimals = 3) double centreY,
    @Column(decimals = 5) double headingRad,
    @Column(decimals = 3) double sizePx,
    @Column(decimals = 4) double confidence)
    implements WingResult {

  /**
   * A step with what is known of the fly then.
   *
   * @param timeUs time on the clock of the events, microseconds
   * @param phase the step
   * @param events events that it was done with
   * @param frequencyHz beat frequency, hertz; NaN if not yet known
   * @param fly where it is; null if not yet known
   * @param confidence of head and tail, 0 to 1; NaN if not yet known
   * @return the step
   */
  public static WingTrackerState of(
      long timeUs,
      Phase phase,
      int events,
      double frequencyHz,
      FlyGeometry fly,
      double confidence) {
    double none = Double.NaN;
    return new WingTrackerState(
        timeUs,
        phase,
        events,
        frequencyHz,
        fly == null ? none : fly.centreX(),
        fly == null ? none : fly.centreY(),
        fly == null ? none : fly.headingRad(),
        fly == null ? none : fly.sizePx(),
        confidence);
  }

  /** What the tracker does. */
  public enum Phase {
    /** Has divided the events into two wings: body, heading up to head and tail, size. */
    TWO_MEANS,
    /** Has found the beat and the body axis. */
    BEAT,
    /** Has found the hinges and the strokes. */
    HINGES,
    /** Has told head from tail. */
    HEAD_AND_TAIL,
    /** Gathers events. */
    COLLECTING,
    /** Tracks both wings. */
    TRACKING,
    /**
     * Follows the events, but not at the frequency of their beat. Nothing but the original's
     * filters goes on then; all others search anew.
     */
    UNLOCKED,
    /** Tracks one wing; there is no second one. */
    ONE_WING,
    /** Has lost the wings and gathers events again. */
    LOST
  }
}
