package haltere.filters.wing;

/**
 * What the running average makes of a wing, where it runs beside the Kalman filter.
 *
 * @param estimate by the running average
 */
public record WingAverage(WingEstimate estimate) implements WingResult {}
