package haltere.filters.object;

import haltere.filters.estimation.GaussianState;

/**
 * What is known of the motions and sizes of objects before any is seen: here of objects of any size
 * that move as they like. States are (x, vx, y, vy) in pixels and px/s.
 *
 * <p>Thread rule: one thread at a time.
 */
public class MotionModel {
  /**
   * Power spectral density of the acceleration, squares of its own size per s³: 2 σ²/τ where
   * velocities have a deviation σ and last for τ (Singer, IEEE TAES 6, 1970).
   */
  private static final double ACCELERATION =
      2 * BirthDetector.SPEED_SIZES_S * BirthDetector.SPEED_SIZES_S * Presence.STOP_HZ;

  /** Takes the prior of the velocity into the state of a birth. */
  protected void begin(GaussianState state) {
    // a birth has the prior of its size already
  }

  /**
   * Predicts a state; here with a velocity that is a random walk.
   *
   * @param sizePx longer side of what is at the position
   * @param dtS how far, seconds
   * @return factor by which what is seen there grows meanwhile
   */
  protected double predict(GaussianState state, double sizePx, double dtS) {
    // what is smaller than a cell of births moves as fast as what fills one
    double size = Math.max(sizePx, ClutterMap.CELL_PX);
    for (int i = 0; i < 4; i += 2) {
      state.shear(i, i + 1, dtS);
      state.addAcceleration(i, i, ACCELERATION * size * size, dtS);
    }
    return 1;
  }

  /** Whether an object without events goes on, and does not come back once it left. */
  protected boolean coasts() {
    return false;
  }

  /** Standard deviation of the rate at which an object turns, rad/s; here half a turn a second. */
  protected double turnRadS() {
    return Math.PI;
  }

  /** Standard deviation of the difference of two objects' displacements, as a share of them. */
  protected double unlikeShare() {
    return 1;
  }

  /** Log ratio of the densities of a box of one object and of one of several, nat, at most 0. */
  protected double oneLog(double lowXPx, double highXPx, double lowYPx) {
    return 0;
  }
}
