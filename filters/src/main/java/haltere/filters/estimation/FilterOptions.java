package haltere.filters.estimation;

import java.util.Objects;

/**
 * How an estimator works, whatever its model.
 *
 * @param gap what happens after a long time without measurements
 * @param lossAfter gated innovations in a row that mean a loss of lock, at least 1
 */
public record FilterOptions(GapPolicy gap, int lossAfter) {
  /** Predictions of at most ten seconds, lock lost after 20 gated innovations. */
  public static final FilterOptions DEFAULT =
      new FilterOptions(GapPolicy.DEFAULT, InnovationMonitor.DEFAULT_LOSS_AFTER);

  /** Validates. */
  public FilterOptions {
    Objects.requireNonNull(gap, "gap");
    Require.atLeast("gated innovations until lock is lost", 1, lossAfter);
  }

  /**
   * The same with another gap policy.
   *
   * @param newGap what happens after a long time without measurements
   * @return a copy
   */
  public FilterOptions withGap(GapPolicy newGap) {
    return new FilterOptions(newGap, lossAfter);
  }

  /**
   * The same with another limit.
   *
   * @param newLossAfter gated innovations in a row that mean a loss of lock, at least 1
   * @return a copy
   */
  public FilterOptions withLossAfter(int newLossAfter) {
    return new FilterOptions(gap, newLossAfter);
  }
}
