package haltere.filters.estimation;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/** How a target changes from one mode of behaviour to another: a Markov chain. */
public final class ModeSwitching {
  private final int modes;
  private final DMatrixRMaj rates;
  private final DMatrixRMaj perStep;

  private ModeSwitching(int modes, DMatrixRMaj rates, DMatrixRMaj perStep) {
    this.modes = modes;
    this.rates = rates;
    this.perStep = perStep;
  }

  /**
   * A target that stays in each mode for a mean time and then takes any other mode alike: the
   * probabilities of a step follow from its length, so that tuning does not depend on the event
   * rate.
   *
   * @param meanStaysS mean stay in each mode in seconds, positive; two modes or more
   * @return the switching
   */
  public static ModeSwitching meanStays(double... meanStaysS) {
    int n = Require.atLeast("modes", 2, meanStaysS.length);
    DMatrixRMaj rates = new DMatrixRMaj(n, n);
    for (int i = 0; i < n; i++) {
      double leave = 1 / Require.positive("mean stay", meanStaysS[i]);
      for (int j = 0; j < n; j++) {
        rates.set(i, j, i == j ? -leave : leave / (n - 1));
      }
    }
    return new ModeSwitching(n, rates, null);
  }

  /**
   * The same probabilities at every step, however long it is.
   *
   * @param probabilities from the mode of the row to that of the column; rows add up to 1; copied
   * @return the switching
   */
  public static ModeSwitching perStep(DMatrixRMaj probabilities) {
    int n = Require.atLeast("modes", 2, probabilities.numRows);
    Require.size("probabilities", probabilities, n, n);
    for (int i = 0; i < n; i++) {
      double sum = 0;
      for (int j = 0; j < n; j++) {
        sum += Require.notNegative("probability", probabilities.get(i, j));
      }
      if (Math.abs(sum - 1) > 1e-9) {
        throw new IllegalArgumentException("row " + i + " adds up to " + sum + ", not to 1");
      }
    }
    return new ModeSwitching(n, null, probabilities.copy());
  }

  /**
   * Number of modes.
   *
   * @return at least 2
   */
  public int modes() {
    return modes;
  }

  /**
   * Probabilities of a step.
   *
   * @param dtS its length in seconds, not negative
   * @return from the mode of the row to that of the column
   */
  public DMatrixRMaj probabilities(double dtS) {
    Require.timeStep(dtS);
    return perStep != null ? perStep.copy() : exponential(dtS);
  }

  /** exp(Λ Δt): a short step by its series, doubled as often as needed. */
  private DMatrixRMaj exponential(double dtS) {
    double fastest = 0;
    for (int i = 0; i < modes; i++) {
      fastest = Math.max(fastest, -rates.get(i, i) * dtS);
    }
    int doublings = fastest <= 0.1 ? 0 : Math.min(1000, Math.getExponent(fastest / 0.1) + 1);
    DMatrixRMaj step = rates.copy();
    CommonOps_DDRM.scale(Math.scalb(dtS, -doublings), step);
    DMatrixRMaj sum = CommonOps_DDRM.identity(modes);
    DMatrixRMaj term = CommonOps_DDRM.identity(modes);
    DMatrixRMaj product = new DMatrixRMaj(modes, modes);
    for (int k = 1; k <= 12; k++) {
      CommonOps_DDRM.mult(1.0 / k, term, step, product);
      term.setTo(product);
      CommonOps_DDRM.addEquals(sum, term);
    }
    for (int i = 0; i < doublings; i++) {
      CommonOps_DDRM.mult(sum, sum, product);
      sum.setTo(product);
      normaliseRows(sum);
    }
    return sum;
  }

  private static void normaliseRows(DMatrixRMaj m) {
    for (int i = 0; i < m.numRows; i++) {
      double sum = 0;
      for (int j = 0; j < m.numCols; j++) {
        sum += m.get(i, j);
      }
      for (int j = 0; j < m.numCols; j++) {
        m.set(i, j, m.get(i, j) / sum);
      }
    }
  }
}
