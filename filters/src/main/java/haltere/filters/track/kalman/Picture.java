package haltere.filters.track.kalman;

import haltere.core.event.SensorGeometry;

/** What the sensor sees, with a border about it. */
record Picture(SensorGeometry geometry) {
  /**
   * Whether a place is in the picture.
   *
   * @param borderPx how far outside counts as inside; negative: how far inside it has to be
   */
  boolean contains(double xPx, double yPx, double borderPx) {
    return xPx > -borderPx
        && yPx > -borderPx
        && xPx < geometry.width() - 1 + borderPx
        && yPx < geometry.height() - 1 + borderPx;
  }
}
