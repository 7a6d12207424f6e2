package haltere.filters.estimation;

/**
 * A time step, P⁻ = F P Fᵀ + Q.
 *
 * @param dtS seconds that were predicted
 * @param transition F
 * @param noise Q
 * @param estimate x⁻ and P⁻, after the step
 */
public record Prediction(double dtS, ConstMatrix transition, ConstMatrix noise, Estimate estimate)
    implements FilterStep {}
