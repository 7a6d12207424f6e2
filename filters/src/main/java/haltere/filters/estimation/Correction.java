package haltere.filters.estimation;

/**
 * A usable measurement, taken in or gated. One that was not a number leaves no step, only a count.
 *
 * @param outcome what became of it
 * @param prior x⁻ and P⁻, before it
 * @param jacobian H
 * @param innovation y = z − h(x⁻)
 * @param innovationCovariance S = H P⁻ Hᵀ + R
 * @param gain K = P⁻ Hᵀ S⁻¹; also of a measurement that was not taken in
 * @param nis normalised innovation squared, yᵀ S⁻¹ y
 * @param logLikelihood ln N(y; 0, S)
 * @param estimate x and P, after it
 */
public record Correction(
    UpdateOutcome outcome,
    Estimate prior,
    ConstMatrix jacobian,
    ConstMatrix innovation,
    ConstMatrix innovationCovariance,
    ConstMatrix gain,
    double nis,
    double logLikelihood,
    Estimate estimate)
    implements FilterStep {}
