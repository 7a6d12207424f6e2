package haltere.filters.estimation;

import org.ejml.data.DMatrixRMaj;

/** A filter under the consistency test, whichever form it has. */
interface Subject {
  void launch(DMatrixRMaj x, DMatrixRMaj p);

  void predict(double dtS);

  void update(DMatrixRMaj z);

  DMatrixRMaj state();

  DMatrixRMaj covariance();

  /** One of the clear filters with its only measurement. */
  static <M extends MeasurementModel> Subject of(Estimator<M> estimator, M measurement) {
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

  /** The written-out filter of a plane. */
  static Subject of(ConstantVelocityPlane plane, double variance) {
    return new Subject() {
      @Override
      public void launch(DMatrixRMaj x, DMatrixRMaj p) {
        plane.x().launch(x.get(0), x.get(1), p.get(0, 0), p.get(1, 1));
        plane.y().launch(x.get(2), x.get(3), p.get(2, 2), p.get(3, 3));
      }

      @Override
      public void predict(double dtS) {
        plane.predict(dtS);
      }

      @Override
      public void update(DMatrixRMaj z) {
        plane.update(z.get(0), z.get(1), variance);
      }

      @Override
      public DMatrixRMaj state() {
        return Matrices.column(
            plane.x().position(), plane.x().velocity(), plane.y().position(), plane.y().velocity());
      }

      @Override
      public DMatrixRMaj covariance() {
        DMatrixRMaj p = new DMatrixRMaj(4, 4);
        put(p, 0, plane.x());
        put(p, 2, plane.y());
        return p;
      }

      private void put(DMatrixRMaj p, int at, ConstantVelocityAxis axis) {
        p.set(at, at, axis.positionVariance());
        p.set(at, at + 1, axis.crossCovariance());
        p.set(at + 1, at, axis.crossCovariance());
        p.set(at + 1, at + 1, axis.velocityVariance());
      }
    };
  }

  /** The written-out filter of four states, on a wing. */
  static Subject ofWing(double variance, double... densities) {
    FourStateEkf ekf = new FourStateEkf(Gate.OPEN, 20);
    return new Subject() {
      @Override
      public void launch(DMatrixRMaj x, DMatrixRMaj p) {
        ekf.setState(x.get(0), x.get(1), x.get(2), x.get(3));
        ekf.setVariances(p.get(0, 0), p.get(1, 1), p.get(2, 2), p.get(3, 3));
      }

      @Override
      public void predict(double dtS) {
        ekf.predict(0, 0, 0, 0, 0, dtS);
        ekf.addNoise(
            densities[0] * dtS, densities[1] * dtS, densities[2] * dtS, densities[3] * dtS);
      }

      @Override
      public void update(DMatrixRMaj z) {
        double sin = Math.sin(ekf.x2());
        double y = Angles.wrapPi(z.get(0) - ekf.x0() - ekf.x1() * sin);
        ekf.update(y, 1, sin, ekf.x1() * Math.cos(ekf.x2()), 0, variance);
      }

      @Override
      public DMatrixRMaj state() {
        return Matrices.column(ekf.x0(), ekf.x1(), ekf.x2(), ekf.x3());
      }

      @Override
      public DMatrixRMaj covariance() {
        DMatrixRMaj p = new DMatrixRMaj(4, 4);
        for (int i = 0; i < 4; i++) {
          for (int j = 0; j < 4; j++) {
            p.set(i, j, ekf.covariance(i, j));
          }
        }
        return p;
      }
    };
  }
}
