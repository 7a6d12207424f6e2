package haltere.filters.wing.internal.stroke;

/**
 * What a wing's filter has said of its phase and frequency at the last looks, about a millisecond
 * apart.
 */
final class FrequencyHistory {
  /** Looks that are kept. */
  static final int LOOKS = 51;

  final double[] timeS = new double[LOOKS];

  /** Phase, not wrapped. */
  final double[] phase = new double[LOOKS];

  final double[] omega = new double[LOOKS];
  final double[] rate = new double[LOOKS];

  /** Variance of omega by the filter. */
  final double[] variance = new double[LOOKS];

  private int last = -1;
  private int size;

  /** Looks at a filter, some time after the last look. */
  void add(double dtS, StrokeEkf filter) {
    double nowS = 0;
    double turned = filter.x[StrokeEkf.PHASE];
    if (size > 0) {
      nowS = timeS[last] + dtS;
      double expected = phase[last] + filter.x[StrokeEkf.OMEGA] * dtS;
      turned += 2 * Math.PI * Math.rint((expected - turned) / (2 * Math.PI));
    }
    last = (last + 1) % LOOKS;
    size = Math.min(LOOKS, size + 1);
    timeS[last] = nowS;
    phase[last] = turned;
    omega[last] = filter.x[StrokeEkf.OMEGA];
    rate[last] = filter.x[StrokeEkf.RATE];
    variance[last] = filter.belief.covariance(StrokeEkf.OMEGA, StrokeEkf.OMEGA);
  }

  /** Place of the look so many looks before the last one. */
  int ago(int looks) {
    return (last + LOOKS - looks) % LOOKS;
  }

  /** How far the frequency is from what was expected of it some looks ago; 0 if none is known. */
  double change(int looks) {
    if (size <= looks) {
      return 0;
    }
    int then = ago(looks);
    return omega[last] - omega[then] - rate[then] * (timeS[last] - timeS[then]);
  }
}
