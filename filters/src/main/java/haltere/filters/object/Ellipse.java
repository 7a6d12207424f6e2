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
  /** Two standard deviations of a covariance. */
  static Ellipse of(double xx, double xy, double yy) {
    double apart = Math.hypot(0.5 * (xx - yy), xy);
    double mean = 0.5 * (xx + yy);
    double angle = 0.5 * Math.atan2(2 * xy, xx - yy);
    return new Ellipse(
        2 * Math.sqrt(mean + apart),
        2 * Math.sqrt(Math.max(0, mean - apart)),
        angle < 0 ? angle + Math.PI : angle);
  }

  /** Two standard deviations of the events of components about a middle. */
  static Ellipse of(List<Component> components, double middleX, double middleY) {
    double all = 0;
    double xx = 0;
    double xy = 0;
    double yy = 0;
    for (Component c : components) {
      double weight = c.activeRate();
      double dx = c.middleX() - middleX;
      double dy = c.middleY() - middleY;
      all += weight;
      xx += weight * (dx * dx + c.shape.varianceX);
      xy += weight * (dx * dy + c.shape.covarianceXy);
      yy += weight * (dy * dy + c.shape.varianceY);
    }
    return of(xx / all, xy / all, yy / all);
  }

  /** The ellipse of the same direction and ratio that touches a box. */
  Ellipse fit(double halfX, double halfY) {
    // a thin line is a pixel wide
    double ratio = major > 1 ? Math.max(1, minor) / major : 1;
    double cos = Math.cos(angleRad);
    double sin = Math.sin(angleRad);
    double x2 = cos * cos + ratio * ratio * sin * sin;
    double y2 = sin * sin + ratio * ratio * cos * cos;
    double longer = Math.sqrt((halfX * halfX + halfY * halfY) / (x2 + y2));
    return new Ellipse(longer, ratio * longer, angleRad);
  }
}
