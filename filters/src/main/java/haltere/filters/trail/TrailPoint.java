package haltere.filters.trail;

/** A row of a tracker: position and velocity of an object in the picture at one time. */
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
