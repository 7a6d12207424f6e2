package haltere.filters.estimation;

/**
 * A filter was set to a state and covariance from outside: at first, or anew.
 *
 * @param estimate what it was set to
 */
public record Launch(Estimate estimate) implements FilterStep {}
