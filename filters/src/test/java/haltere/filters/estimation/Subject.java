package haltere.filters.estimation;

import org.ejml.data.DMatrixRMaj;

/** A filter under the consistency test, whichever form it has. */
interface Subject {
  void launch(DMatrixRMaj x, DMatrixRMaj p);

  void predict(double dtS);

  void update(DMatrixRMaj z);

  DMatrixRMaj state();

  DMatrixRMaj covariance();

  /** An estimator over models with its only measurement. */
  static Subject of(KalmanFilter estimator, MeasurementModel measurement) {
    return new Subject() {
      @Override
      public void launch(DMatrixRMaj x, DMatrixRMaj p) {
        estimator.launch(x, p);
      }

      @Override
      public void predict(double dtS) {
        estimator.predict(dtS);
      }

      @Override
      public void update(DMatrixRMaj z) {
        estimator.update(measurement, z);
      }

      @Override
      public DMatrixRMaj state() {
        return estimator.estimate().state().toMatrix();
      }

      @Override
      public DMatrixRMaj covariance() {
        return estimator.estimate().covariance().toMatrix();
      }
    };
  }

  /** The kernel without models, on the edge of a wing. */
  static Subject ofKernel(double variance, double... densities) {
    GaussianState belief = new GaussianState(4);
    double[] row = {1, 0, 0, 0};
    return new Subject() {
      @Override
      public void launch(DMatrixRMaj x, DMatrixRMaj p) {
        belief.set(x, p);
      }

      @Override
      public void predict(double dtS) {
        belief.shear(2, 3, dtS);
        for (int i = 0; i < 4; i++) {
          belief.addNoise(i, densities[i] * dtS);
        }
      }

      @Override
      public void update(DMatrixRMaj z) {
        row[1] = Math.sin(belief.mean(2));
        row[2] = belief.mean(1) * Math.cos(belief.mean(2));
        belief.project(row);
        double expected = belief.mean(0) + belief.mean(1) * row[1];
        belief.correct(Angles.wrapPi(z.get(0) - expected), variance);
      }

      @Override
      public DMatrixRMaj state() {
        return belief.mean().copy();
      }

      @Override
      public DMatrixRMaj covariance() {
        return belief.covariance().copy();
      }
    };
  }
}
