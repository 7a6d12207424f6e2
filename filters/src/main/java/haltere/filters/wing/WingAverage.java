package haltere.filters.wing;

/**
 * Estimate of a running average beside the Kalman filter.
 *
 * @param estimate by the running average
 */
public record WingAverage(WingEstimate estimate) implements WingResult {}
