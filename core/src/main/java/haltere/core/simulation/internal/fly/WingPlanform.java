package haltere.core.simulation.internal.fly;

/**
 * The outline of a wing and its projection from above. The pitch axis divides the chord; the
 * visible share of both parts is the projection: 1 for a chord in the stroke plane, 0 for one
 * across it, negative for a wing that has flipped over.
 *
 * <p>Thread rule: immutable.
 */
final class WingPlanform {
  /** Corners along an edge; they are closer together where the outline is round. */
  static final int CORNERS = 24;

  private static final int SAMPLES = 64;

  private final MembraneSettings settings;
  private final double largest;
  private final double[] span = new double[CORNERS + 1];
  private final double[] chord = new double[CORNERS + 1];
  private final double[] sampleWeight = new double[SAMPLES];
  private final double[] sampleSlope = new double[SAMPLES];

  WingPlanform(MembraneSettings settings) {
    this.settings = settings;
    double root = settings.rootExponent();
    double tip = settings.tipExponent();
    double at = root / (root + tip);
    largest = StrictMath.pow(at, root) * StrictMath.pow(1 - at, tip);
    for (int i = 0; i <= CORNERS; i++) {
      double u = (1 - StrictMath.cos(Math.PI * i / CORNERS)) / 2;
      span[i] = u * settings.lengthPx();
      chord[i] = chordPx(u);
    }
    double sum = 0;
    for (int i = 0; i < SAMPLES; i++) {
      double u = (i + 0.5) / SAMPLES;
      sampleSlope[i] = chordPx(u) / (u * settings.lengthPx());
      sampleWeight[i] = u * u * chordPx(u);
      sum += sampleWeight[i];
    }
    for (int i = 0; i < SAMPLES; i++) {
      sampleWeight[i] /= sum;
    }
  }

  private double chordPx(double u) {
    double root = StrictMath.pow(u, settings.rootExponent());
    double tip = StrictMath.pow(1 - u, settings.tipExponent());
    return settings.chordShare() * settings.lengthPx() * root * tip / largest;
  }

  /** Distance of a corner from the hinge along the axis, pixels. */
  double spanPx(int corner) {
    return span[corner];
  }

  /**
   * Distance from the axis of a line that divides the whole chord, pixels, positive in front.
   *
   * @param corner 0 at the hinge to {@link #CORNERS} at the tip
   * @param share of the chord in front of the line: 0 is the leading edge, 1 the trailing edge
   */
  double acrossPx(int corner, double share) {
    return (settings.axisShare() - share) * chord[corner];
  }

  /** Largest distance of a point of the wing from its hinge, pixels. */
  double reachPx() {
    return settings.lengthPx() * Math.hypot(1, settings.chordShare());
  }

  /** Largest distance of a point of the wing from its axis, pixels. */
  double acrossPx() {
    return settings.lengthPx() * settings.chordShare();
  }

  /**
   * Angle of an edge of the wing from its axis, as seen from the hinge: the mean over the area of
   * the wing, weighted with the square of the distance from the hinge. So the mean of both edges is
   * the axis of least second moment of the projection about the hinge, the wing's long axis as an
   * image shows it, up to the third power of chord over length.
   *
   * @param projection visible share of the chord
   * @param share 0 for the leading edge, 1 for the trailing edge
   * @return radians, positive in front of the axis
   */
  double edgeRad(double projection, double share) {
    double across = projection * (settings.axisShare() - share);
    double sum = 0;
    for (int i = 0; i < SAMPLES; i++) {
      sum += sampleWeight[i] * StrictMath.atan(across * sampleSlope[i]);
    }
    return sum;
  }
}
