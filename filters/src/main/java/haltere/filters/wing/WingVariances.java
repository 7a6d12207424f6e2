package haltere.filters.wing;

import haltere.core.sink.Column;

/**
 * How sure a Kalman filter is of its state at a time, and what it thinks of its measurements: the
 * covariance of centre, amplitude, phase and angular frequency.
 *
 * @param timeUs time on the clock of the events, microseconds
 * @param edge the wing, or the edge where there is a filter for each edge
 * @param centreRad2 variance of the centre, squared radians
 * @param amplitudeRad2 variance of the amplitude, squared radians
 * @param phaseRad2 variance of the phase, squared radians
 * @param frequencyRad2PerS2 variance of the angular frequency, squared radians a squared second
 * @param centreAmplitudeRad2 covariance of centre and amplitude, squared radians
 * @param centrePhaseRad2 covariance of centre and phase, squared radians
 * @param centreFrequencyRad2PerS covariance of centre and angular frequency, squared radians a
 *     second
 * @param amplitudePhaseRad2 covariance of amplitude and phase, squared radians
 * @param amplitudeFrequencyRad2PerS covariance of amplitude and angular frequency, squared radians
 *     a second
 * @param phaseFrequencyRad2PerS covariance of phase and angular frequency, squared radians a second
 * @param measurementRad2 variance of a measurement, squared radians
 * @param nis mean normalised innovation squared of late, 1 if the filter knows how good it is
 */
public record WingVariances(
    @Column("t_us") long timeUs,
    WingPart edge,
    double centreRad2,
    double amplitudeRad2,
    double phaseRad2,
    double frequencyRad2PerS2,
    double centreAmplitudeRad2,
    double centrePhaseRad2,
    double centreFrequencyRad2PerS,
    double amplitudePhaseRad2,
    double amplitudeFrequencyRad2PerS,
    double phaseFrequencyRad2PerS,
    double measurementRad2,
    @Column(decimals = 4) double nis)
    implements WingResult {
  /**
   * Picks what is told of the numbers of a filter.
   *
   * @param timeUs time on the clock of the events, microseconds
   * @param f the filter, whose state begins with centre, amplitude, phase and angular frequency
   * @return the variances and covariances of those four
   */
  public static WingVariances of(long timeUs, WingFilterState f) {
    double[] p = f.p();
    int size = f.names().size();
    return new WingVariances(
        timeUs,
        f.part(),
        p[0],
        p[size + 1],
        p[2 * size + 2],
        p[3 * size + 3],
        p[1],
        p[2],
        p[3],
        p[size + 2],
        p[size + 3],
        p[2 * size + 3],
        f.r(),
        f.nis());
  }
}
