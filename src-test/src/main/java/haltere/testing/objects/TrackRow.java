package haltere.testing.objects;

/**
 * State of an object at one time by a tracker. Values that it does not state are NaN.
 *
 * @param timeUs on the clock of the events, microseconds
 * @param id identity of the track
 * @param xPx column, pixels
 * @param yPx row, pixels upwards
 * @param vxPxS velocity to the right, pixels a second
 * @param vyPxS velocity upwards, pixels a second
 * @param sdXPx standard deviation of the column, pixels
 * @param sdYPx standard deviation of the row, pixels
 * @param sdVxPxS standard deviation of the velocity to the right, pixels a second
 * @param sdVyPxS standard deviation of the velocity upwards, pixels a second
 * @param majorPx longer half axis of the extent, pixels
 * @param minorPx shorter half axis of the extent, pixels
 * @param angleRad direction of the longer axis, counterclockwise from x, radians
 */
public record TrackRow(
    long timeUs,
    int id,
    double xPx,
    double yPx,
    double vxPxS,
    double vyPxS,
    double sdXPx,
    double sdYPx,
    double sdVxPxS,
    double sdVyPxS,
    double majorPx,
    double minorPx,
    double angleRad) {
  /**
   * A row that states a position only.
   *
   * @param timeUs on the clock of the events, microseconds
   * @param id identity of the track
   * @param xPx column, pixels
   * @param yPx row, pixels upwards
   */
  public TrackRow(long timeUs, int id, double xPx, double yPx) {
    this(timeUs, id, xPx, yPx, Double.NaN, Double.NaN);
  }

  /**
   * A row that states a position and a velocity.
   *
   * @param timeUs on the clock of the events, microseconds
   * @param id identity of the track
   * @param xPx column, pixels
   * @param yPx row, pixels upwards
   * @param vxPxS velocity to the right, pixels a second
   * @param vyPxS velocity upwards, pixels a second
   */
  public TrackRow(long timeUs, int id, double xPx, double yPx, double vxPxS, double vyPxS) {
    this(
        timeUs,
        id,
        xPx,
        yPx,
        vxPxS,
        vyPxS,
        Double.NaN,
        Double.NaN,
        Double.NaN,
        Double.NaN,
        Double.NaN,
        Double.NaN,
        Double.NaN);
  }
}
