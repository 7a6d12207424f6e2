package haltere.filters.estimation.motion;

import haltere.filters.estimation.ProcessModel;
import haltere.filters.estimation.Require;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * A damped harmonic oscillator whose damping and frequency are to be found: state (s, v, ζ, ω).
 *
 * <pre>
 * ds/dt = v     dv/dt = −ω² s − 2 ζ ω v     dζ/dt = 0     dω/dt = 0
 * </pre>
 *
 * <p>State and Jacobian go together through Runge-Kutta 4, dF/dt = J(x) F, in as many steps as the
 * oscillation needs; so F is the exact Jacobian of the state as it is computed. White acceleration
 * drives v, and ζ and ω may wander. J's second row is (−ω², −2ζω, −2ωv, −2ωs − 2ζv); the worked
 * example of {@code docs/estimation.md} uses it.
 *
 * <p>Thread rule: holds workspaces; not safe for use by two threads at a time.
 */
public final class DampedOscillator implements ProcessModel {
  /** Entry of the displacement s. */
  public static final int POSITION = 0;

  /** Entry of the velocity v, in units of s per second. */
  public static final int VELOCITY = 1;

  /** Entry of the damping ratio ζ. */
  public static final int DAMPING = 2;

  /** Entry of the undamped angular frequency ω, in rad/s. */
  public static final int FREQUENCY = 3;

  private static final int N = 4;
  private static final int MAX_STEPS = 10_000;

  /** Radians of the oscillation in one Runge-Kutta step. */
  private static final double STEP_RAD = 0.1;

  private final double accelerationDensity;
  private final double dampingDensity;
  private final double frequencyDensity;
  private final RungeKutta4 flow = new RungeKutta4(N, DampedOscillator::derivative);
  private final RungeKutta4 flowWithJacobian =
      new RungeKutta4(N + N * N, DampedOscillator::derivativeWithJacobian);
  private final double[] state = new double[N];
  private final double[] stateAndJacobian = new double[N + N * N];
  private final DMatrixRMaj stepF = new DMatrixRMaj(N, N);
  private final DMatrixRMaj stepQ = new DMatrixRMaj(N, N);
  private final DMatrixRMaj product = new DMatrixRMaj(N, N);

  /**
   * An oscillator.
   *
   * @param accelerationDensity spectral density of the acceleration, in unit²/s³
   * @param dampingDensity spectral density of the change of ζ, per second
   * @param frequencyDensity spectral density of the change of ω, in rad²/s³
   */
  public DampedOscillator(
      double accelerationDensity, double dampingDensity, double frequencyDensity) {
    this.accelerationDensity = Require.notNegative("acceleration density", accelerationDensity);
    this.dampingDensity = Require.notNegative("damping density", dampingDensity);
    this.frequencyDensity = Require.notNegative("frequency density", frequencyDensity);
  }

  @Override
  public int stateSize() {
    return N;
  }

  @Override
  public void evolve(DMatrixRMaj x, double dtS, DMatrixRMaj evolved) {
    System.arraycopy(x.data, 0, state, 0, N);
    flow.integrate(state, dtS, steps(x, dtS));
    System.arraycopy(state, 0, evolved.data, 0, N);
  }

  @Override
  public void jacobian(DMatrixRMaj x, double dtS, DMatrixRMaj f) {
    System.arraycopy(x.data, 0, stateAndJacobian, 0, N);
    identity();
    flowWithJacobian.integrate(stateAndJacobian, dtS, steps(x, dtS));
    System.arraycopy(stateAndJacobian, N, f.data, 0, N * N);
  }

  /**
   * {@inheritDoc} Q of one Runge-Kutta step h in closed form, with the pushes of its beginning,
   * then Q ← F Q Fᵀ + Q(h) from step to step.
   */
  @Override
  public void noise(DMatrixRMaj x, double dtS, DMatrixRMaj q) {
    int steps = steps(x, dtS);
    double h = dtS / steps;
    System.arraycopy(x.data, 0, state, 0, N);
    q.zero();
    for (int k = 0; k < steps; k++) {
      noiseOfStep(h);
      if (k > 0) {
        System.arraycopy(state, 0, stateAndJacobian, 0, N);
        identity();
        flowWithJacobian.integrate(stateAndJacobian, h, 1);
        System.arraycopy(stateAndJacobian, N, stepF.data, 0, N * N);
        CommonOps_DDRM.mult(stepF, q, product);
        CommonOps_DDRM.multTransB(product, stepF, q);
      }
      flow.integrate(state, h, 1);
      CommonOps_DDRM.addEquals(q, stepQ);
    }
  }

  private void noiseOfStep(double h) {
    double s = state[POSITION];
    double v = state[VELOCITY];
    double zeta = state[DAMPING];
    double omega = state[FREQUENCY];
    stepQ.zero();
    for (int i = 0; i < 2; i++) {
      for (int j = 0; j < 2; j++) {
        stepQ.set(i, j, accelerationDensity * AxisBlocks.integratedWhiteNoise(2, i, j, h));
      }
    }
    addParameterNoise(DAMPING, -2 * omega * v, dampingDensity, h);
    addParameterNoise(FREQUENCY, -2 * omega * s - 2 * zeta * v, frequencyDensity, h);
  }

  /** A parameter that wanders pushes v, and v moves s: three integrators in a row. */
  private void addParameterNoise(int parameter, double push, double density, double h) {
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        double weight = density * (i == 2 ? 1 : push) * (j == 2 ? 1 : push);
        stepQ.add(
            i == 2 ? parameter : i,
            j == 2 ? parameter : j,
            weight * AxisBlocks.integratedWhiteNoise(3, i, j, h));
      }
    }
  }

  private void identity() {
    for (int i = 0; i < N * N; i++) {
      stateAndJacobian[N + i] = i % (N + 1) == 0 ? 1 : 0;
    }
  }

  private static int steps(DMatrixRMaj x, double dtS) {
    double omega = Math.abs(x.get(FREQUENCY));
    double rate = omega * (1 + Math.abs(x.get(DAMPING)));
    return (int) Math.max(1, Math.min(MAX_STEPS, Math.ceil(rate * dtS / STEP_RAD)));
  }

  private static void derivative(double[] x, double[] dx) {
    dx[POSITION] = x[VELOCITY];
    dx[VELOCITY] =
        -x[FREQUENCY] * x[FREQUENCY] * x[POSITION] - 2 * x[DAMPING] * x[FREQUENCY] * x[VELOCITY];
    dx[DAMPING] = 0;
    dx[FREQUENCY] = 0;
  }

  private static void derivativeWithJacobian(double[] x, double[] dx) {
    derivative(x, dx);
    double s = x[POSITION];
    double v = x[VELOCITY];
    double zeta = x[DAMPING];
    double omega = x[FREQUENCY];
    for (int j = 0; j < N; j++) {
      double fs = x[N + j];
      double fv = x[2 * N + j];
      double fz = x[3 * N + j];
      double fw = x[4 * N + j];
      dx[N + j] = fv;
      dx[2 * N + j] =
          -omega * omega * fs
              - 2 * zeta * omega * fv
              - 2 * omega * v * fz
              + (-2 * omega * s - 2 * zeta * v) * fw;
      dx[3 * N + j] = 0;
      dx[4 * N + j] = 0;
    }
  }
}
