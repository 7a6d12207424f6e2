package haltere.filters.orientation.internal.axis;

/**
 * Model of an axis and its lines. Angular rates decay and are driven by noise of calm flight or of
 * saccades.
 *
 * @param calmRateRadS standard deviation of a rate in calm flight, radians a second
 * @param saccadeRateRadS standard deviation of a rate in a saccade, radians a second
 * @param decayS time constant of the rates, seconds
 * @param saccadesPerS rate of saccades
 * @param saccadeS mean duration of a saccade, seconds
 * @param updateNoise variance that quaternions add at each update instead, 0 for none
 * @param gateRad largest residual of a line
 * @param outlierShare probability that a line is an outlier
 */
public record AxisModel(
    double calmRateRadS,
    double saccadeRateRadS,
    double decayS,
    double saccadesPerS,
    double saccadeS,
    double updateNoise,
    double gateRad,
    double outlierShare) {
  double saccadeShare() {
    return saccadesPerS * saccadeS / (1 + saccadesPerS * saccadeS);
  }

  /** Variance of a rate, over calm flight and saccades. */
  double meanRateVariance() {
    double share = saccadeShare();
    return (1 - share) * calmRateRadS * calmRateRadS + share * saccadeRateRadS * saccadeRateRadS;
  }
}
