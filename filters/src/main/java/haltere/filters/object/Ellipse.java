package haltere.filters.object;

import java.util.List;

/**
 * An ellipse about a middle.
 *
 * @param major longer half axis, pixels
 * @param minor shorter half axis, pixels
 * @param angleRad direction of the longer axis, radians modulo π
 */
record Ellipse(double major, double minor, double angleRad) {
  /** Largest correlation of x and y, so that a line has a width. */
  private static final double MAX_CORRELATION = 0.99;

  /** The ellipse x² / xx + … = 1 of a matrix, whose box has the half sides √xx and √yy. */
  static Ellipse of(double xx, double xy, double yy) {
    double apart = Math.hypot(0.5 * (xx - yy), xy);
    double mean = 0.5 * (xx + yy);
    double angle = 0.5 * Math.atan2(2 * xy, xx - yy);
    return new Ellipse(
        Math.sqrt(mean + apart),
        Math.sqrt(Math.max(0, mean - apart)),
        angle < 0 ? angle + Math.PI : angle);
  }

  /** The ellipse within a box whose axes are correlated as the events of components are. */
  static Ellipse of(
      List<Component> components, double middleX, double middleY, double halfX, double halfY) {
    double xx = 0;
    double xy = 0;
    double yy = 0;
    for (Component c : components) {
      double weight = c.activeRate();
      double dx = c.middleX() - middleX;
      double dy = c.middleY() - middleY;
      xx += weight * (dx * dx + c.shape.varianceX);
      xy += weight * (dx * dy + c.shape.covarianceXy);
      yy += weight * (dy * dy + c.shape.varianceY);
    }
    double correlation = xx > 0 && yy > 0 ? xy / Math.sqrt(xx * yy) : 0;
    double bounded = Math.max(-MAX_CORRELATION, Math.min(MAX_CORRELATION, correlation));
    return of(halfX * halfX, bounded * halfX * halfY, halfY * halfY);
  }
}
