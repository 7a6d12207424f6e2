package haltere.filters.estimation.motion;

import haltere.filters.estimation.ProcessModel;
import java.util.Arrays;
import org.ejml.data.DMatrixRMaj;

/**
 * A damped harmonic oscillator with unknown damping and frequency, without process noise: state (s,
 * v, ζ, ω).
 *
 * <pre>
 * ds/dt = v     dv/dt = a = −ω² s − 2 ζ ω v     dζ/dt = 0     dω/dt = 0
 * </pre>
 *
 * <p>State and Jacobian are integrated together by Runge-Kutta 4, dF/dt = J(x) F, with steps by the
 * frequency, so that F is the exact Jacobian of the computed state.
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

  private final double maxRateRadS;
  private final RungeKutta4 flow = new RungeKutta4(N, DampedOscillator::derivative);
  private final RungeKutta4 flowWithJacobian =
      new RungeKutta4(N + N * N, this::derivativeWithJacobian);
  private final double[] state = new double[N];
  private final double[] stateAndJacobian = new double[N + N * N];
  private final double[] slope = new double[N];

  /**
   * An oscillator.
   *
   * @param maxRateRadS ω (1 + |ζ|) above which the motion is unknown (NaN): too fast for the
   *     measurements; infinite for none
   */
  public DampedOscillator(double maxRateRadS) {
    this.maxRateRadS = maxRateRadS;
  }

  @Override
  public int stateSize() {
    return N;
  }

  @Override
  public void evolve(DMatrixRMaj x, double dtS, DMatrixRMaj evolved) {
    System.arraycopy(x.data, 0, state, 0, N);
    integrate(flow, state, dtS);
    System.arraycopy(state, 0, evolved.data, 0, N);
  }

  @Override
  public void jacobian(DMatrixRMaj x, double dtS, DMatrixRMaj f) {
    System.arraycopy(x.data, 0, stateAndJacobian, 0, N);
    for (int i = 0; i < N * N; i++) {
      stateAndJacobian[N + i] = i % (N + 1) == 0 ? 1 : 0;
    }
    integrate(flowWithJacobian, stateAndJacobian, dtS);
    System.arraycopy(stateAndJacobian, N, f.data, 0, N * N);
  }

  @Override
  public void noise(DMatrixRMaj x, double dtS, DMatrixRMaj q) {
    q.zero();
  }

  private void integrate(RungeKutta4 method, double[] x, double dtS) {
    double rate = Math.abs(x[FREQUENCY]) * (1 + Math.abs(x[DAMPING]));
    if (rate <= maxRateRadS) {
      method.integrate(
          x, dtS, (int) Math.max(1, Math.min(MAX_STEPS, Math.ceil(rate * dtS / STEP_RAD))));
    } else {
      Arrays.fill(x, Double.NaN);
    }
  }

  /**
   * The acceleration, a.
   *
   * @param x state, four numbers
   * @return in units of s per second squared
   */
  public static double acceleration(double[] x) {
    return -x[FREQUENCY] * x[FREQUENCY] * x[POSITION] - 2 * x[DAMPING] * x[FREQUENCY] * x[VELOCITY];
  }

  /**
   * The derivative of the acceleration by the state.
   *
   * @param x state, four numbers
   * @param row gets ∂a/∂x, four numbers
   */
  public static void accelerationSlope(double[] x, double[] row) {
    double omega = x[FREQUENCY];
    row[POSITION] = -omega * omega;
    row[VELOCITY] = -2 * x[DAMPING] * omega;
    row[DAMPING] = -2 * omega * x[VELOCITY];
    row[FREQUENCY] = -2 * omega * x[POSITION] - 2 * x[DAMPING] * x[VELOCITY];
  }

  private static void derivative(double[] x, double[] dx) {
    dx[POSITION] = x[VELOCITY];
    dx[VELOCITY] = acceleration(x);
    dx[DAMPING] = 0;
    dx[FREQUENCY] = 0;
  }

  private void derivativeWithJacobian(double[] x, double[] dx) {
    derivative(x, dx);
    accelerationSlope(x, slope);
    Arrays.fill(dx, N, dx.length, 0);
    for (int j = 0; j < N; j++) {
      dx[N + j] = x[2 * N + j];
      for (int k = 0; k < N; k++) {
        dx[2 * N + j] += slope[k] * x[N + k * N + j];
      }
    }
  }
}
