package haltere.filters.wing.internal.stroke;

/** Last estimates of phase and frequency of a wing, about a millisecond apart. */
final class FrequencyHistory {
  static final int SAMPLES = 51;

  final double[] timeS = new double[SAMPLES];

  /** Phase, not wrapped. */
  final double[] phase = new double[SAMPLES];

  final double[] omega = new double[SAMPLES];
  final double[] rate = new double[SAMPLES];

  /** Variance of omega in the filter. */
  final double[] variance = new double[SAMPLES];

  private int last = -1;
  private int size;

  /** Adds the present estimate of a filter, a time after the last one. */
  void add(double dtS, StrokeEkf filter) {
    double nowS = 0;
    double turned = filter.x[StrokeEkf.PHASE];
    if (size > 0) {
      nowS = timeS[last] + dtS;
      double expected = phase[last] + filter.x[StrokeEkf.OMEGA] * dtS;
      turned += 2 * Math.PI * Math.rint((expected - turned) / (2 * Math.PI));
    }
    last = (last + 1) % SAMPLES;
    size = Math.min(SAMPLES, size + 1);
    timeS[last] = nowS;
    phase[last] = turned;
    omega[last] = filter.x[StrokeEkf.OMEGA];
    rate[last] = filter.x[StrokeEkf.RATE];
    variance[last] = filter.belief.covariance(StrokeEkf.OMEGA, StrokeEkf.OMEGA);
  }

  /** Index of an earlier sample. */
  int ago(int samples) {
    return (last + SAMPLES - samples) % SAMPLES;
  }

  /** Frequency minus its prediction some samples ago; 0 if there is none. */
  double change(int samples) {
    if (size <= samples) {
      return 0;
    }
    int then = ago(samples);
    return omega[last] - omega[then] - rate[then] * (timeS[last] - timeS[then]);
  }
}
