package haltere.filters.estimation;

/**
 * Counts measurements taken in and gated, and finds losses of lock: runs of gated innovations.
 *
 * <p>A measurement that cannot be used (NaN) neither lengthens nor ends a run. Thread rule: that of
 * its estimator.
 */
public final class InnovationMonitor {
  /** Gated innovations in a row that mean a loss of lock of a {@link KalmanFilter}. */
  public static final int LOSS_AFTER = 20;

  private final int lossAfter;
  private long applied;
  private long gated;
  private int run;

  /**
   * A monitor that has seen nothing.
   *
   * @param lossAfter gated innovations in a row that mean a loss of lock, at least 1
   */
  public InnovationMonitor(int lossAfter) {
    this.lossAfter = Require.atLeast("gated innovations until lock is lost", 1, lossAfter);
  }

  /** {@return {@link UpdateOutcome#APPLIED}, noted as a measurement that was taken in} */
  public UpdateOutcome noteApplied() {
    applied++;
    run = 0;
    return UpdateOutcome.APPLIED;
  }

  /**
   * Notes a measurement outside the gate.
   *
   * @return {@link UpdateOutcome#GATED}, or {@link UpdateOutcome#LOCK_LOST} as long as the lock is
   *     lost
   */
  public UpdateOutcome noteGated() {
    gated++;
    run++;
    return lockLost() ? UpdateOutcome.LOCK_LOST : UpdateOutcome.GATED;
  }

  /** Ends the present run, as a new launch of the filter does; the counts stay. */
  public void endRun() {
    run = 0;
  }

  /**
   * {@return whether lock is lost: the last innovations in a row were gated, and too many of them}
   */
  public boolean lockLost() {
    return run >= lossAfter;
  }

  /** {@return the number of measurements taken in} */
  public long applied() {
    return applied;
  }

  /** {@return the number of measurements outside the gate} */
  public long gated() {
    return gated;
  }
}
