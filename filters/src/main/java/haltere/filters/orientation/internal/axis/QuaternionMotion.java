package haltere.filters.orientation.internal.axis;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * A prediction of {@link BodyQuaternion}'s seven states with its Jacobian and noise: exact, q ⊗
 * exp(½ g ω), with the noise of driven rates; or as Straw et al. (2011), Euler's with the same
 * variance for all states. Reused.
 */
final class QuaternionMotion {
  /** Transition of errors over the last step, 7 x 7. */
  final DMatrixRMaj transition = new DMatrixRMaj(7, 7);

  /** Covariance that the last step added, 7 x 7. */
  final DMatrixRMaj noise = new DMatrixRMaj(7, 7);

  private final double tau;
  private final double rateVariance;
  private final double updateNoise;
  private final RateDecay decay;

  /**
   * Motion with a time constant and a variance of the rates, and the variance that each step adds
   * to all states; 0 for exact steps.
   */
  QuaternionMotion(double tau, double rateVariance, double updateNoise) {
    this.tau = tau;
    this.rateVariance = rateVariance;
    this.updateNoise = updateNoise;
    decay = new RateDecay(tau);
  }

  /** Predicts the states by a time above 0. */
  void step(double[] x, double dtS) {
    transition.zero();
    noise.zero();
    if (updateNoise > 0) {
      eulerStep(x, dtS);
    } else {
      exactStep(x, dtS);
      addNoise(BodyQuaternion.byRates(x));
    }
  }

  /** x ← x + f Δt, F = I + Δt ∂f/∂x at a quaternion of length 1. */
  private void eulerStep(double[] x, double dtS) {
    double[] rate = BodyQuaternion.derivative(x, tau);
    DMatrixRMaj byRates = BodyQuaternion.byRates(x);
    DMatrixRMaj byQuaternion = BodyQuaternion.byQuaternion(x);
    CommonOps_DDRM.scale(0.5 * dtS, byRates);
    CommonOps_DDRM.scale(0.5 * dtS, byQuaternion);
    for (int i = 0; i < 4; i++) {
      byQuaternion.add(i, i, 1);
      for (int j = 0; j < 4; j++) {
        // the derivative of 1/n
        byQuaternion.add(i, j, -dtS * rate[3 + i] * x[3 + j]);
      }
    }
    setTransition(1 - dtS / tau, byRates, byQuaternion);
    for (int i = 0; i < 7; i++) {
      x[i] += rate[i] * dtS;
      noise.set(i, i, updateNoise);
    }
  }

  private void exactStep(double[] x, double dtS) {
    decay.step(dtS);
    double g = decay.reachS;
    double speed = Math.sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    double halfAngle = 0.5 * g * speed;
    double ratio = speed * g < 1e-8 ? 0.5 * g : Math.sin(halfAngle) / speed;
    double cos = Math.cos(halfAngle);
    double bend = speed * g < 1e-4 ? -g * g * g / 24 : (0.5 * g * cos - ratio) / (speed * speed);
    // (q⁺) = (cos + ratio Ω) q; by the rates: Ξ (ratio + bend ω ωᵀ) − ½ g ratio q ωᵀ
    DMatrixRMaj rates = new DMatrixRMaj(3, 1, true, x[0], x[1], x[2]);
    DMatrixRMaj before = new DMatrixRMaj(4, 1, true, x[3], x[4], x[5], x[6]);
    DMatrixRMaj vector = new DMatrixRMaj(3, 3);
    DMatrixRMaj byRates = new DMatrixRMaj(4, 3);
    CommonOps_DDRM.multTransB(bend, rates, rates, vector);
    for (int i = 0; i < 3; i++) {
      vector.add(i, i, ratio);
      x[i] *= decay.left;
    }
    CommonOps_DDRM.multTransB(-0.5 * g * ratio, before, rates, byRates);
    CommonOps_DDRM.multAdd(BodyQuaternion.byRates(x), vector, byRates);
    DMatrixRMaj byQuaternion = BodyQuaternion.byQuaternion(rates.data);
    CommonOps_DDRM.scale(ratio, byQuaternion);
    for (int i = 0; i < 4; i++) {
      byQuaternion.add(i, i, cos);
    }
    DMatrixRMaj after = new DMatrixRMaj(4, 1);
    CommonOps_DDRM.mult(byQuaternion, before, after);
    System.arraycopy(after.data, 0, x, 3, 4);
    setTransition(decay.left, byRates, byQuaternion);
  }

  private void setTransition(double left, DMatrixRMaj byRates, DMatrixRMaj byQuaternion) {
    for (int i = 0; i < 3; i++) {
      transition.set(i, i, left);
    }
    CommonOps_DDRM.insert(byRates, transition, 3, 0);
    CommonOps_DDRM.insert(byQuaternion, transition, 3, 3);
  }

  /** The noise of driven rates, which ½ Ξ maps to the quaternion after the step. */
  private void addNoise(DMatrixRMaj byRates) {
    DMatrixRMaj block = new DMatrixRMaj(4, 4);
    CommonOps_DDRM.multTransB(0.25 * rateVariance * decay.angleNoise, byRates, byRates, block);
    CommonOps_DDRM.insert(block, noise, 3, 3);
    CommonOps_DDRM.scale(0.5 * rateVariance * decay.jointNoise, byRates);
    CommonOps_DDRM.insert(byRates, noise, 3, 0);
    CommonOps_DDRM.insert(CommonOps_DDRM.transpose(byRates, null), noise, 0, 3);
    for (int i = 0; i < 3; i++) {
      noise.set(i, i, rateVariance * decay.rateNoise);
    }
  }
}
