package haltere.filters.wing.internal.stroke;

import haltere.filters.wing.WingPart;

/** Hinge and reference direction of a wing; converts pixels to stroke angles. */
public final class StrokeFrame {
  private static final double MIN_RADIUS_PX = 1;

  final WingPart side;
  private final double turn;
  private double hingeX;
  private double hingeY;
  private double headingRad;
  private double headingCos = 1;
  private double headingSin;
  private double innerSquare = MIN_RADIUS_PX;
  double outerSquare;
  boolean isManual;

  /** Offset of the last event from the hinge, and its squared distance. */
  double dx;

  double dy;
  double square;

  /**
   * A frame that has to be {@link #place placed}.
   *
   * @param side which wing
   */
  public StrokeFrame(WingPart side) {
    this.side = side;
    turn = side == WingPart.LEFT ? 1 : -1;
  }

  /** {@return the sense of stroke angles on the sensor: 1 for the left wing, -1 for the right} */
  public double turn() {
    return turn;
  }

  /**
   * Places the wing.
   *
   * @param x column of the hinge
   * @param y row of the hinge
   * @param heading from tail to head, counterclockwise from +x, radians
   * @param innerPx pixels nearer to the hinge are outside the region of interest
   * @param outerPx pixels farther from the hinge as well
   */
  public void place(double x, double y, double heading, double innerPx, double outerPx) {
    hingeX = x;
    hingeY = y;
    setHeading(heading);
    double inner = Math.max(MIN_RADIUS_PX, innerPx);
    innerSquare = inner * inner;
    outerSquare = outerPx * outerPx;
  }

  /**
   * Sets whether the hinge was set manually.
   *
   * @param manual true if it was
   */
  public void setManual(boolean manual) {
    isManual = manual;
  }

  /**
   * Sets the reference direction of stroke angles.
   *
   * @param heading from tail to head, counterclockwise from +x, radians
   */
  public void setHeading(double heading) {
    headingRad = heading;
    headingCos = Math.cos(heading);
    headingSin = Math.sin(heading);
  }

  /**
   * Moves the hinge.
   *
   * @param byX columns
   * @param byY rows
   */
  public void shift(double byX, double byY) {
    hingeX += byX;
    hingeY += byY;
  }

  /** {@return the column of the hinge} */
  public double hingeX() {
    return hingeX;
  }

  /** {@return the row of the hinge} */
  public double hingeY() {
    return hingeY;
  }

  /** {@return the reference direction, from tail to head, radians counterclockwise from +x} */
  public double headingRad() {
    return headingRad;
  }

  /**
   * Computes the offset of a pixel from the hinge.
   *
   * @param x column
   * @param y row
   * @return false if it is outside the region of interest
   */
  public boolean look(double x, double y) {
    dx = x - hingeX;
    dy = y - hingeY;
    square = dx * dx + dy * dy;
    return square >= innerSquare && square <= outerSquare;
  }

  /** {@return the stroke angle of the last pixel, in (-pi, pi]; just beyond the tail near -pi} */
  public double angle() {
    double along = dx * headingCos + dy * headingSin;
    double across = dy * headingCos - dx * headingSin;
    return FastAngle.of(turn * across, along);
  }
}
