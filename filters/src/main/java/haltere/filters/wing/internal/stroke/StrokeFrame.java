package haltere.filters.wing.internal.stroke;

import haltere.filters.wing.WingPart;

/** Where a wing is hinged and from where its stroke angle is measured; turns pixels into angles. */
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
  boolean isByHand;

  /** Of the event last looked at: from the hinge, and the square of the distance. */
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

  /** {@return which way stroke angles grow on the sensor: 1 for the left wing, -1 for the right} */
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
   * @param outerPx and pixels further off
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
   * Says whether a person has put the hinge where it is.
   *
   * @param said true if so
   */
  public void setByHand(boolean said) {
    isByHand = said;
  }

  /**
   * Turns the direction that stroke angles refer to.
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

  /**
   * {@return the direction that stroke angles refer to: from tail to head, counterclockwise from
   * +x}
   */
  public double headingRad() {
    return headingRad;
  }

  /**
   * Looks at a pixel.
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

  /**
   * {@return the stroke angle of the pixel last looked at, in (-pi, pi]; just beyond the tail is
   * near -pi}
   */
  public double angle() {
    double along = dx * headingCos + dy * headingSin;
    double across = dy * headingCos - dx * headingSin;
    return FastAngle.of(turn * across, along);
  }
}
