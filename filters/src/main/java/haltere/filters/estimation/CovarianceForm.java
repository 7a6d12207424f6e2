package haltere.filters.estimation;

/** How an estimator holds its covariance. */
public enum CovarianceForm {
  /**
   * The matrix P itself, updated in Joseph's form, (I − K H) P (I − K H)ᵀ + K R Kᵀ, and made
   * symmetric: Bucy and Joseph (1968). The usual choice.
   */
  JOSEPH,
  /**
   * The factors of P = U D Uᵀ, U unit upper triangular and D diagonal: Bierman's (1977) measurement
   * update and Thornton's (1976) time update. For states whose scales lie many powers of ten apart,
   * or measurements far better than the prior: P cannot lose its positivity.
   */
  UD
}
