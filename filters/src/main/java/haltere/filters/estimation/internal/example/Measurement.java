package haltere.filters.estimation.internal.example;

/**
 * A measurement of a motion along a line.
 *
 * @param tS time, seconds
 * @param xM displacement, metres
 * @param aMS2 acceleration along x, m/s², or NaN if it was not measured
 */
public record Measurement(double tS, double xM, double aMS2) {}
