package haltere.filters.wing;

import haltere.core.sink.Column;
import haltere.filters.estimation.ConstMatrix;

/**
 * Covariance of a Kalman filter at a time, of centre, amplitude, phase and angular frequency, and
 * variance of its measurements.
 *
 * @param timeUs time on the clock of the events, microseconds
 * @param edge the wing, or the edge with a filter for each edge
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
 * @param nis recent mean normalised innovation squared, 1 if the filter is consistent
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
   * Selects the variances from the numbers of a filter.
   *
   * @param timeUs time on the clock of the events, microseconds
   * @param f the filter, whose state begins with centre, amplitude, phase and angular frequency
   * @return the variances and covariances of those four
   */
  public static WingVariances of(long timeUs, WingFilterState f) {
    ConstMatrix p = f.p();
    return new WingVariances(
        timeUs,
        f.part(),
        p.get(0, 0),
        p.get(1, 1),
        p.get(2, 2),
        p.get(3, 3),
        p.get(0, 1),
        p.get(0, 2),
        p.get(0, 3),
        p.get(1, 2),
        p.get(1, 3),
        p.get(2, 3),
        f.r(),
        f.nis());
  }
}
