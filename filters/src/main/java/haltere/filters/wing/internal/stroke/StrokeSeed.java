package haltere.filters.wing.internal.stroke;

/**
 * Initial stroke of an estimator, from the search or from another estimator.
 *
 * @param timeUs time of the phase, microseconds
 * @param centre mean stroke angle
 * @param amplitude of the first harmonic
 * @param phase of the first harmonic: the angle is centre + amplitude sin(phase) + harmonics
 * @param omega angular frequency
 * @param halfWidth of the wing as seen
 * @param lagS of ON behind OFF events, seconds
 * @param cosines terms of the second, third, ... harmonic relative to the phase
 * @param sines terms of the second, third, ... harmonic relative to the phase
 */
public record StrokeSeed(
    long timeUs,
    double centre,
    double amplitude,
    double phase,
    double omega,
    double halfWidth,
    double lagS,
    double[] cosines,
    double[] sines) {

  /** The state of a filter at a time. */
  double[] state(int harmonics, long atUs) {
    double[] x = new double[StrokeEkf.SERIES + 2 * (harmonics - 1)];
    x[StrokeEkf.CENTRE] = centre;
    x[StrokeEkf.AMPLITUDE] = amplitude;
    x[StrokeEkf.PHASE] = phase + omega * (atUs - timeUs) * 1e-6;
    x[StrokeEkf.OMEGA] = omega;
    x[StrokeEkf.WIDTH] = halfWidth;
    x[StrokeEkf.LAG] = lagS;
    for (int k = 0; k < Math.min(harmonics - 1, cosines.length); k++) {
      x[StrokeEkf.SERIES + 2 * k] = cosines[k];
      x[StrokeEkf.SERIES + 2 * k + 1] = sines[k];
    }
    return x;
  }

  /** Standard deviations of {@link #state}. */
  static double[] sd(int harmonics) {
    double[] sd = new double[StrokeEkf.SERIES + 2 * (harmonics - 1)];
    sd[StrokeEkf.CENTRE] = 0.05;
    sd[StrokeEkf.AMPLITUDE] = 0.05;
    sd[StrokeEkf.PHASE] = 0.1;
    sd[StrokeEkf.OMEGA] = 2 * Math.PI;
    sd[StrokeEkf.WIDTH] = 0.01;
    sd[StrokeEkf.LAG] = 30e-6;
    sd[StrokeEkf.RATE] = 100;
    for (int i = StrokeEkf.SERIES; i < sd.length; i++) {
      sd[i] = i < StrokeEkf.SERIES + 2 ? 0.03 : 0.015;
    }
    return sd;
  }

  /** {@return the same stroke in the opposite direction, as of a wing on the other side} */
  public StrokeSeed mirrored() {
    double[] c = cosines.clone();
    double[] s = sines.clone();
    for (int k = 0; k < c.length; k++) {
      double sign = k % 2 == 0 ? -1 : 1;
      c[k] *= sign;
      s[k] *= sign;
    }
    return new StrokeSeed(
        timeUs, Math.PI - centre, amplitude, phase + Math.PI, omega, halfWidth, lagS, c, s);
  }

  /**
   * The same stroke with another centre.
   *
   * @param changed mean stroke angle
   * @return the other stroke
   */
  public StrokeSeed withCentre(double changed) {
    return new StrokeSeed(
        timeUs, changed, amplitude, phase, omega, halfWidth, lagS, cosines, sines);
  }

  double angleAt(long atUs) {
    double at = phase + omega * (atUs - timeUs) * 1e-6;
    double sum = centre + amplitude * Math.sin(at);
    for (int k = 0; k < cosines.length; k++) {
      sum += cosines[k] * Math.cos((k + 2) * at) + sines[k] * Math.sin((k + 2) * at);
    }
    return sum;
  }

  /**
   * A sinusoid of a wing of usual width.
   *
   * @param timeUs time of the phase, microseconds
   * @param centre mean stroke angle
   * @param amplitude half of peak to peak
   * @param phase 0 at the passage of the centre towards the tail
   * @param omega angular frequency
   * @param lagS of ON behind OFF events, seconds
   * @return the stroke
   */
  public static StrokeSeed sinusoid(
      long timeUs, double centre, double amplitude, double phase, double omega, double lagS) {
    double[] none = {};
    return new StrokeSeed(timeUs, centre, amplitude, phase, omega, 0.02, lagS, none, none);
  }
}
