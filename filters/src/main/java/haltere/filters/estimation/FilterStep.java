package haltere.filters.estimation;

/** A step of an estimator, with its intermediates for tests, plots and smoothing. */
public sealed interface FilterStep {
  /** {@return the estimate after the step: state, covariance and time} */
  Estimate estimate();

  /**
   * A filter was set to a state and covariance, initially or again.
   *
   * @param estimate the new estimate
   */
  record Launch(Estimate estimate) implements FilterStep {}

  /**
   * A time step, P⁻ = F P Fᵀ + Q.
   *
   * @param dtS seconds that were predicted
   * @param transition F
   * @param noise Q
   * @param estimate x⁻ and P⁻, after the step
   */
  record Prediction(double dtS, ConstMatrix transition, ConstMatrix noise, Estimate estimate)
      implements FilterStep {}

  /**
   * A usable measurement, applied or gated. One that was not a number leaves no step.
   *
   * @param outcome its outcome
   * @param prior x⁻ and P⁻, before it
   * @param innovation y = z − h(x⁻)
   * @param innovationCovariance S = H P⁻ Hᵀ + R
   * @param gain K = P⁻ Hᵀ S⁻¹; also of a gated measurement
   * @param nis normalised innovation squared, yᵀ S⁻¹ y
   * @param estimate x and P, after it
   */
  record Correction(
      UpdateOutcome outcome,
      Estimate prior,
      ConstMatrix innovation,
      ConstMatrix innovationCovariance,
      ConstMatrix gain,
      double nis,
      Estimate estimate)
      implements FilterStep {}
}
