package haltere.filters.track;

/**
 * Covariance of a position on the road.
 *
 * @param lateralM2 variance across the road, m²
 * @param crossM2 covariance of the position across and along, m²
 * @param distanceM2 variance along the road, m²
 */
public record GroundCovariance(double lateralM2, double crossM2, double distanceM2) {}
