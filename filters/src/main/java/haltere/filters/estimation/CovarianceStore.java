package haltere.filters.estimation;

import org.ejml.data.DMatrixRMaj;

/** Holds a covariance in one of the {@link CovarianceForm}s. */
interface CovarianceStore {
  static CovarianceStore of(CovarianceForm form, int size) {
    return form == CovarianceForm.UD ? new UdCovariance(size) : new JosephCovariance(size);
  }

  void set(DMatrixRMaj p);

  /** P, valid until the next change; not to be changed. */
  DMatrixRMaj matrix();

  /** P ← F P Fᵀ + Q. */
  void predict(DMatrixRMaj f, DMatrixRMaj q);

  /** Takes in the measurement of a computed innovation and says what the state has to add: K y. */
  void correct(Innovation innovation, DMatrixRMaj stateChange);
}
