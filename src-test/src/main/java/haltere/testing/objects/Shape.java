package haltere.testing.objects;

/**
 * The form of a simulated object in its own coordinates, whose origin is the middle of its extent.
 *
 * @param kind type of the form
 * @param a half extent along u, pixels
 * @param b half extent along v, pixels
 * @param strokePx width of lines, pixels
 */
record Shape(ShapeKind kind, double a, double b, double strokePx) {
  /** Kinds of forms. */
  enum ShapeKind {
    /** A filled ellipse. */
    ELLIPSE,
    /** A filled rectangle. */
    RECTANGLE,
    /** An ellipse of which only the outline is seen. */
    RING,
    /** A rectangle of which only the outline is seen. */
    FRAME,
    /** A leading and a trailing edge across u. */
    EDGES,
    /** A person who walks along u, upright in v. */
    WALKER
  }

  /** Height of a walker over half its width. */
  static final double WALKER_ASPECT = 2.2;

  private static final double SWING_RAD = 0.5;

  /** Distance a walker covers in a cycle of the gait, in heights. */
  private static final double STRIDE = 0.86;

  /** Phase of a walker's limbs after a distance, radians. */
  double gaitRad(double distancePx) {
    return 2 * Math.PI * distancePx / (STRIDE * 2 * b);
  }

  /** Covered share of a pixel, 0 to 1, with borders one pixel wide. */
  double coverage(double u, double v, double gaitRad) {
    double inside =
        switch (kind) {
          case ELLIPSE -> inEllipse(u, v, a, b);
          case RECTANGLE -> Math.min(a - Math.abs(u), b - Math.abs(v));
          case RING -> line(inEllipse(u, v, a, b));
          case FRAME -> line(Math.min(a - Math.abs(u), b - Math.abs(v)));
          case EDGES -> Math.min(line(a - Math.abs(u)), b - Math.abs(v));
          case WALKER -> inWalker(u, v, gaitRad);
        };
    return Math.max(0, Math.min(1, inside + 0.5));
  }

  private double line(double inside) {
    return Math.min(inside, strokePx - inside);
  }

  private static double inEllipse(double u, double v, double a, double b) {
    double scaled = length(u / a, v / b);
    return (1 - scaled) * Math.min(a, b);
  }

  private double inWalker(double u, double v, double gaitRad) {
    double h = 2 * b;
    double best = 0.07 * h - length(u, v - 0.43 * h);
    best = Math.max(best, inEllipse(u, v - 0.13 * h, 0.09 * h, 0.22 * h));
    double swing = SWING_RAD * Math.sin(gaitRad);
    for (int side = -1; side <= 1; side += 2) {
      best = Math.max(best, inLimb(u, v + 0.05 * h, side * swing, 0.42 * h));
      best = Math.max(best, inLimb(u, v - 0.28 * h, -side * swing, 0.32 * h));
    }
    return best;
  }

  /** Math.hypot guards against overflow, which takes most of the time here. */
  private static double length(double u, double v) {
    return Math.sqrt(u * u + v * v);
  }

  /** Inside a limb that hangs from the origin. */
  private double inLimb(double u, double v, double angleRad, double length) {
    double along = u * Math.sin(angleRad) - v * Math.cos(angleRad);
    double across = u * Math.cos(angleRad) + v * Math.sin(angleRad);
    double beyond = Math.max(0, Math.max(-along, along - length));
    return strokePx / 2 - length(across, beyond);
  }

  /** Half extents of the form turned by an angle, as a box around the origin. */
  Box extent(double angleRad) {
    double c = Math.abs(Math.cos(angleRad));
    double s = Math.abs(Math.sin(angleRad));
    return switch (kind) {
      case ELLIPSE, RING -> Box.around(0, 0, Math.hypot(a * c, b * s), Math.hypot(a * s, b * c));
      default -> Box.around(0, 0, a * c + b * s, a * s + b * c);
    };
  }
}
