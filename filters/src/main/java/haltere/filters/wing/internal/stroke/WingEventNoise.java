package haltere.filters.wing.internal.stroke;

/**
 * What the events of a wing are worth, those of each edge by themselves: a slow pixel's OFF events
 * come while the wing is over it or not at all, its ON events when its light has come back, at
 * times that spread over hundreds of microseconds.
 *
 * <p>Tells as well when a filter no longer is where its wing is: more events near the wing are
 * refused than outliers explain. Those that are taken in then say that all is well.
 */
final class WingEventNoise {
  /** Residuals below this, radians, lie near the wing. */
  private static final double NEAR_RAD = 0.45;

  private static final double FOLLOW = 0.002;

  /**
   * Share of the events that is refused near a wing, beyond outliers, if the filter is not there.
   */
  private static final double TOO_MANY = 0.1;

  private final double[] judged = new double[2];
  private final EventNoise[] edges;
  private double refused;

  /**
   * Noise of events of which nothing is known yet: innovations beyond the gate are refused, a fixed
   * variance of 0 is learnt.
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

  /** Counts an event of an edge that was judged. */
  void count(int edge, double y, boolean taken) {
    judged[edge]++;
    refused += FOLLOW * ((taken || Math.abs(y) >= NEAR_RAD ? 0 : 1) - refused);
  }

  /** Whether a residual that was refused is one of too many near the wing. */
  boolean isOneOfTooMany(double y) {
    double outliers = 2 * NEAR_RAD * mean(edges[0].outliers(), edges[1].outliers());
    return Math.abs(y) < NEAR_RAD && refused > TOO_MANY + outliers;
  }

  private double mean(double leading, double trailing) {
    double all = judged[0] + judged[1];
    return all == 0 ? leading : (judged[0] * leading + judged[1] * trailing) / all;
  }

  /** Mean normalised innovation squared of late, of the events of both edges. */
  double nis() {
    return mean(edges[0].nis(), edges[1].nis());
  }

  /**
   * Share of the events near the wing that chance does not explain, about 0 if all are outliers.
   */
  double excess() {
    return mean(edges[0].excess(), edges[1].excess());
  }
}
