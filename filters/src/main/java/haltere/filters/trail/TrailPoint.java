package haltere.filters.trail;

/** A row of a tracker: where an object is in the picture at one time, and how fast it moves. */
public interface TrailPoint {
  /** {@return time on the clock of the events, microseconds} */
  long timeUs();

  /** {@return identity of the object} */
  int id();

  /** {@return column, pixels} */
  double xPx();

  /** {@return row, pixels upwards} */
  double yPx();

  /** {@return velocity to the right, pixels a second} */
  double vxPxS();

  /** {@return velocity upwards, pixels a second} */
  double vyPxS();
}
