package haltere.filters.wing;

import haltere.core.sink.Column;

/**
 * A step of the search for the fly, or a change of the tracked wings.
 *
 * @param timeUs time on the clock of the events, microseconds
 * @param phase the new phase of the tracker, or the step just done
 * @param events number of events of the step
 * @param frequencyHz beat frequency at this time, hertz; NaN if unknown
 * @param centreX body centre at this time, pixels; NaN if unknown
 * @param centreY body centre at this time, pixels; NaN if unknown
 * @param headingRad heading at this time; NaN if unknown
 * @param sizePx size at this time, pixels; NaN if unknown
 * @param confidence of head and tail at this time, 0 to 1; NaN if unknown
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
   * A step with the present knowledge of the fly.
   *
   * @param timeUs time on the clock of the events, microseconds
   * @param phase the step
   * @param events number of events of the step
   * @param frequencyHz beat frequency, hertz; NaN if unknown
   * @param fly its geometry; null if unknown
   * @param confidence of head and tail, 0 to 1; NaN if unknown
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

  /** A phase of the tracker. */
  public enum Phase {
    /** Has divided the events into two wings: body, heading up to head and tail, size. */
    TWO_MEANS,
    /** Has found the beat and the body axis. */
    BEAT,
    /** Has found the hinges and the strokes. */
    HINGES,
    /** Has resolved head and tail. */
    HEAD_AND_TAIL,
    /** Collects events. */
    COLLECTING,
    /** Tracks both wings. */
    TRACKING,
    /**
     * Tracks at another frequency than that of the beat. Only the filters of Cardinale (2006)
     * continue then; all others search again.
     */
    UNLOCKED,
    /** Tracks one wing; there is no second one. */
    ONE_WING,
    /** Has lost the wings and collects events again. */
    LOST
  }
}
