package haltere.filters.wing.internal.stroke;

/**
 * Noise of the events of a wing, for each edge: OFF events of a slow pixel occur while the wing
 * covers it or not at all, its ON events when the light returns, with a scatter of hundreds of
 * microseconds.
 *
 * <p>Also detects divergence: more events near the wing are rejected than outliers explain.
 */
final class WingEventNoise {
  /** Largest residual near the wing, radians. */
  private static final double NEAR_RAD = 0.45;

  private static final double FOLLOW = 0.002;

  /**
   * Share of events near the wing rejected beyond outliers, above which the filter has diverged.
   */
  private static final double MAX_EXCESS = 0.1;

  private final double[] counted = new double[2];
  private final EventNoise[] edges;
  private double rejected;

  /**
   * Initial noise. Innovations beyond the gate are rejected; a fixed variance of 0 is estimated.
   */
  WingEventNoise(double gateSd, double fixed) {
    edges = new EventNoise[] {new EventNoise(gateSd, fixed), new EventNoise(gateSd, fixed)};
  }

  void apply(double gateSd, double fixed) {
    edges[0].apply(gateSd, fixed);
    edges[1].apply(gateSd, fixed);
  }

  /** Noise of the events of an edge, 0 leading, 1 trailing. */
  EventNoise of(int edge) {
    return edges[edge];
  }

  void count(int edge, double y, boolean taken) {
    counted[edge]++;
    rejected += FOLLOW * ((taken || Math.abs(y) >= NEAR_RAD ? 0 : 1) - rejected);
  }

  /** Whether a residual is near the wing while more are rejected there than outliers explain. */
  boolean isExcessRejection(double y) {
    double outliers = 2 * NEAR_RAD * mean(edges[0].outliers(), edges[1].outliers());
    return Math.abs(y) < NEAR_RAD && rejected > MAX_EXCESS + outliers;
  }

  private double mean(double leading, double trailing) {
    double all = counted[0] + counted[1];
    return all == 0 ? leading : (counted[0] * leading + counted[1] * trailing) / all;
  }

  /** Recent mean normalised innovation squared of both edges. */
  double nis() {
    return mean(edges[0].nis(), edges[1].nis());
  }

  /** Share of the events near the wing beyond chance; about 0 if all are outliers. */
  double excess() {
    return mean(edges[0].excess(), edges[1].excess());
  }
}
