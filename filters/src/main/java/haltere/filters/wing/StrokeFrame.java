package haltere.filters.wing;

/**
 * Where a wing is hinged and from where its stroke angle is measured; turns pixels into angles.
 *
 * <p>Thread rule: one thread at a time.
 */
final class StrokeFrame {
  private static final double LEAST_RADIUS_PX = 1;

  private final double turn;
  private double hingeX;
  private double hingeY;
  private double headingRad;
  private double headingCos = 1;
  private double headingSin;
  private double innerSquare = LEAST_RADIUS_PX;
  private double outerSquare;
  private boolean byHand;

  /** Of the event last looked at: from the hinge, and the square of the distance. */
  double dx;

  double dy;
  double square;

  StrokeFrame(WingSide side) {
    turn = side == WingSide.LEFT ? 1 : -1;
  }

  /** 1 for the left wing, -1 for the right. */
  double turn() {
    return turn;
  }

  void place(double x, double y, double heading, double innerPx, double outerPx) {
    hingeX = x;
    hingeY = y;
    setHeading(heading);
    double inner = Math.max(LEAST_RADIUS_PX, innerPx);
    innerSquare = inner * inner;
    outerSquare = outerPx * outerPx;
  }

  /** Says whether a person has put the hinge where it is. */
  void setByHand(boolean said) {
    byHand = said;
  }

  boolean isByHand() {
    return byHand;
  }

  void setHeading(double heading) {
    headingRad = heading;
    headingCos = Math.cos(heading);
    headingSin = Math.sin(heading);
  }

  void shift(double byX, double byY) {
    hingeX += byX;
    hingeY += byY;
  }

  double hingeX() {
    return hingeX;
  }

  double hingeY() {
    return hingeY;
  }

  double headingRad() {
    return headingRad;
  }

  /** Looks at a pixel; false if it is outside the region of interest. */
  boolean look(double x, double y) {
    dx = x - hingeX;
    dy = y - hingeY;
    square = dx * dx + dy * dy;
    return square >= innerSquare && square <= outerSquare;
  }

  /** Stroke angle of the pixel last looked at, in (-pi, pi]; just beyond the tail is near -pi. */
  double angle() {
    double along = dx * headingCos + dy * headingSin;
    double across = dy * headingCos - dx * headingSin;
    return FastAngle.of(turn * across, along);
  }
}
