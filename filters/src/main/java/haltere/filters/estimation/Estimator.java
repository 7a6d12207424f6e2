package haltere.filters.estimation;

import java.util.Arrays;
import org.ejml.data.DMatrixRMaj;

/**
 * Predicts a state through time and corrects it by measurements.
 *
 * <p>Time steps are seconds and must be finite and not negative: a caller whose clock jumps back
 * launches anew. A step of 0 predicts nothing. A measurement that is not finite is refused with
 * {@link UpdateOutcome#UNUSABLE} and leaves the estimate as it is.
 *
 * <p>Thread rule: not safe for use by two threads at a time.
 */
public interface Estimator {
  /**
   * Dimension of the state.
   *
   * @return at least 1
   */
  int stateSize();

  /**
   * Begins (again) from a state. The clock and the counts go on; a run of gated innovations ends.
   *
   * @param x state, copied
   * @param p its covariance, symmetric and positive definite, copied
   */
  void launch(DMatrixRMaj x, DMatrixRMaj p);

  /**
   * Predicts over a time step.
   *
   * @param dtS seconds, finite and not negative
   */
  void predict(double dtS);

  /**
   * Takes in a measurement, unless it lies outside its gate.
   *
   * @param model how it comes from the state
   * @param z the measurement, not kept
   * @return what became of it
   * @throws ArithmeticException if the state leaves the numbers, as that of a diverged extended
   *     filter may; launch anew
   */
  UpdateOutcome update(MeasurementModel model, DMatrixRMaj z);

  /**
   * Takes in a measurement given as numbers; allocates.
   *
   * @param model how it comes from the state
   * @param z the measurement
   * @return what became of it
   */
  default UpdateOutcome update(MeasurementModel model, double... z) {
    return update(model, new DMatrixRMaj(z.length, 1, true, Arrays.copyOf(z, z.length)));
  }

  /**
   * One entry of the state.
   *
   * @param index from 0
   * @return in the state's own unit
   */
  double state(int index);

  /**
   * One entry of the covariance.
   *
   * @param row from 0
   * @param column from 0
   * @return in the product of the two entries' units
   */
  double covariance(int row, int column);

  /**
   * What the estimator holds to be true now.
   *
   * @return an immutable copy
   */
  Estimate estimate();

  /**
   * What became of the measurements so far.
   *
   * @return the estimator's own monitor
   */
  InnovationMonitor monitor();

  /**
   * How often a gap made the estimator begin again.
   *
   * @return at least 0
   */
  long relaunches();
}
