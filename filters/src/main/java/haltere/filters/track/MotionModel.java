package haltere.filters.track;

/** What a track is expected to do. */
public enum MotionModel {
  /** Goes straight on, as far as the process noise lets it: one Kalman filter. */
  STRAIGHT,
  /** Goes straight on, turns, or does anything: interacting models. */
  MANOEUVRING
}
