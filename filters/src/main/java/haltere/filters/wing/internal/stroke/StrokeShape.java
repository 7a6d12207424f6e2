package haltere.filters.wing.internal.stroke;

/** Extremes of a stroke and phase of its passage of the centre towards the tail. */
final class StrokeShape {
  private static final int STEPS = 32;
  private static final double[] COS = new double[STEPS];
  private static final double[] SIN = new double[STEPS];

  static {
    for (int i = 0; i < STEPS; i++) {
      COS[i] = StrictMath.cos(2 * Math.PI * i / STEPS);
      SIN[i] = StrictMath.sin(2 * Math.PI * i / STEPS);
    }
  }

  private final double[] value = new double[STEPS];

  /** State of the last stroke. */
  private double[] seen = new double[0];

  /** Smallest and largest stroke angle. */
  double min;

  double max;

  /** Phase of the passage of the centre towards the tail. */
  double crossingRad;

  /** Half of peak to peak. */
  double amplitude() {
    return (max - min) / 2;
  }

  /** Sets the stroke of a filter; repeated if centre, amplitude or harmonics have changed. */
  void of(StrokeEkf filter) {
    if (filter.hasSeries(seen)) {
      return;
    }
    seen = filter.x.clone();
    int low = 0;
    int high = 0;
    for (int i = 0; i < STEPS; i++) {
      value[i] = filter.angle(COS[i], SIN[i]);
      low = value[i] < value[low] ? i : low;
      high = value[i] > value[high] ? i : high;
    }
    min = vertex(low);
    max = vertex(high);
    double phase = 0;
    for (int round = 0; round < 4; round++) {
      double c = Math.cos(phase);
      double s = Math.sin(phase);
      double slope = filter.slope(c, s);
      if (slope < 0.2 * filter.x[StrokeEkf.AMPLITUDE]) {
        break;
      }
      phase -= (filter.angle(c, s) - filter.x[StrokeEkf.CENTRE]) / slope;
      phase = Math.max(-1, Math.min(1, phase));
    }
    crossingRad = phase;
  }

  /** The extreme of the parabola through a value and its neighbours. */
  private double vertex(int at) {
    double before = value[(at + STEPS - 1) % STEPS];
    double after = value[(at + 1) % STEPS];
    double bend = before - 2 * value[at] + after;
    double slope = (after - before) / 2;
    return bend == 0 ? value[at] : value[at] - slope * slope / (2 * bend);
  }
}
