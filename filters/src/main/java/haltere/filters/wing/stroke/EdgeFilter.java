package haltere.filters.wing.stroke;

import haltere.filters.estimation.Angles;
import haltere.filters.estimation.Gate;
import haltere.filters.estimation.GaussianState;
import haltere.filters.estimation.InnovationMonitor;

/**
 * The extended Kalman filter of one edge of a wing: centre a, amplitude M, phase ξ, angular
 * frequency ω, with h = a + M sin ξ (Cardinale 2006, eq. 11 to 14, whose Jacobian is mended).
 *
 * <p>Times in seconds, angles in radians. Thread rule: one thread at a time.
 */
final class EdgeFilter {
  static final int CENTRE = 0;
  static final int AMPLITUDE = 1;
  static final int PHASE = 2;
  static final int OMEGA = 3;
  static final int SIZE = 4;

  final GaussianState belief = new GaussianState(SIZE);
  final InnovationMonitor monitor;
  private final double threshold;
  private final double[] row = {1, 0, 0, 0};
  private double nis = Double.NaN;
  private double expected;

  EdgeFilter(Gate gate, int lossAfter) {
    threshold = gate.threshold(1);
    monitor = new InnovationMonitor(lossAfter);
  }

  /** The phase turns on; its error gathers that of the frequency. */
  void predict(double dtS) {
    belief.shear(PHASE, OMEGA, dtS);
  }

  /** Takes in an angle, unless it lies outside the gate. */
  void update(double angle, double variance) {
    double phase = belief.mean(PHASE);
    double amplitude = belief.mean(AMPLITUDE);
    double sin = Math.sin(phase);
    row[AMPLITUDE] = sin;
    row[PHASE] = amplitude * Math.cos(phase);
    double innovation = Angles.wrapPi(angle - (belief.mean(CENTRE) + amplitude * sin));
    expected = angle - innovation;
    nis = innovation * innovation / (belief.project(row) + variance);
    if (nis > threshold) {
      monitor.noteGated();
    } else if (belief.correct(innovation, variance)) {
      monitor.noteApplied();
      mend();
    } else {
      monitor.noteUnusable();
    }
  }

  /** Keeps the phase small, so that it stays exact, and the amplitude positive. */
  private void mend() {
    double phase = belief.mean(PHASE);
    double amplitude = belief.mean(AMPLITUDE);
    if (amplitude < 0) {
      belief.setMean(AMPLITUDE, -amplitude);
      belief.scale(AMPLITUDE, -1);
      phase += Math.PI;
    }
    belief.setMean(PHASE, Angles.wrapPi(phase));
  }

  /** What the last angle was compared with. */
  double expected() {
    return expected;
  }

  /** Normalised innovation squared of the last angle, NaN before the first. */
  double nis() {
    return nis;
  }

  /** Stroke angle when the phase has turned on. */
  double angleAfter(double turn) {
    return belief.mean(CENTRE) + belief.mean(AMPLITUDE) * Math.sin(belief.mean(PHASE) + turn);
  }

  /** Standard deviation of the stroke angle when the phase has turned on. */
  double sdAngleAfter(double turn) {
    double phase = belief.mean(PHASE) + turn;
    row[AMPLITUDE] = Math.sin(phase);
    row[PHASE] = belief.mean(AMPLITUDE) * Math.cos(phase);
    return Math.sqrt(Math.max(0, belief.project(row)));
  }
}
