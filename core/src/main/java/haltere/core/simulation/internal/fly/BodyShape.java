package haltere.core.simulation.internal.fly;

/**
 * The outline of a fly's body from above: head, thorax and abdomen as three ellipses along the
 * axis.
 *
 * <p>Thread rule: immutable.
 */
final class BodyShape {
  /** Centre on the axis (forward of the hinges), half length, half width, in body lengths. */
  private static final double[][] PARTS = {
    {0.30, 0.10, 0.15}, // head
    {0.05, 0.21, 0.155}, // thorax
    {-0.32, 0.28, 0.14} // abdomen
  };

  private static final double MAX_SIDEWAYS = 0.155;

  /** Half of the width over which the outline is blurred, pixels. */
  private static final double BLUR = 1;

  private final double length;

  BodyShape(double lengthPx) {
    length = lengthPx;
  }

  /** Largest distance of a point of the body from the midpoint of the hinges, pixels. */
  double reach() {
    return 0.6 * length;
  }

  /**
   * Distance from the outline, negative inside; close to exact near the outline.
   *
   * @param forward along the axis from the midpoint of the hinges, pixels
   * @param sideways from the axis, pixels
   */
  double distance(double forward, double sideways) {
    double nearest = Double.POSITIVE_INFINITY;
    for (double[] part : PARTS) {
      double x = forward - part[0] * length;
      double ex = x / (part[1] * length);
      double ey = sideways / (part[2] * length);
      double k0 = Math.sqrt(ex * ex + ey * ey);
      double gx = ex / (part[1] * length);
      double gy = ey / (part[2] * length);
      double k1 = Math.sqrt(gx * gx + gy * gy);
      double distance = k1 == 0 ? -part[2] * length : k0 * (k0 - 1) / k1;
      nearest = Math.min(nearest, distance);
    }
    return nearest;
  }

  /** Distance of a point of the sensor from the outline of the body in a pose. */
  double distance(FlyPose pose, double x, double y) {
    double dx = x - pose.centreX;
    double dy = y - pose.centreY;
    double forward = dx * pose.cosHeading + dy * pose.sinHeading;
    double sideways = dy * pose.cosHeading - dx * pose.sinHeading;
    return distance(forward, sideways);
  }

  /** Whether a point of the sensor lies on the body in a pose. */
  boolean covers(FlyPose pose, double x, double y) {
    double dx = x - pose.centreX;
    double dy = y - pose.centreY;
    double sideways = dy * pose.cosHeading - dx * pose.sinHeading;
    if (Math.abs(sideways) > MAX_SIDEWAYS * length) {
      return false;
    }
    double forward = dx * pose.cosHeading + dy * pose.sinHeading;
    return Math.abs(forward) < reach() && distance(forward, sideways) < 0;
  }

  /** Share of a pixel's light that the body absorbs, from the distance to its outline. */
  static double cover(double distance) {
    if (distance >= BLUR) {
      return 0;
    }
    if (distance <= -BLUR) {
      return 1;
    }
    double share = (BLUR - distance) / (2 * BLUR);
    return share * share * (3 - 2 * share);
  }

  /** Distance from the outline beyond which a motion of one pixel changes no light, pixels. */
  static double band() {
    return BLUR + 1.2;
  }
}
