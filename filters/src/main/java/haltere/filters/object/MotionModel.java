package haltere.filters.object;

import haltere.filters.estimation.GaussianState;

/**
 * Prior of motions and sizes of objects, here of any size and free motion. States are (x, vx, y,
 * vy) in pixels and px/s.
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

  /** Applies the prior of the velocity to the state of a birth. */
  protected void begin(GaussianState state) {
    // a birth has the prior of its size already
  }

  /**
   * Predicts a state; here with a velocity that is a random walk.
   *
   * @param sizePx longer side of the component
   * @param dtS time step, seconds
   * @return growth of the component in the picture, a factor
   */
  protected double predict(GaussianState state, double sizePx, double dtS) {
    // components smaller than a cell of births move as fast as those that fill one
    double size = Math.max(sizePx, ClutterMap.CELL_PX);
    for (int i = 0; i < 4; i += 2) {
      state.shear(i, i + 1, dtS);
      state.addAcceleration(i, i, ACCELERATION * size * size, dtS);
    }
    return 1;
  }

  /** Whether objects without events continue, and do not return after they left. */
  protected boolean coasts() {
    return false;
  }

  /** Standard deviation of the rate at which an object turns, rad/s; here half a turn a second. */
  protected double turnRadS() {
    return Math.PI;
  }

  /** Standard deviation of a side of an object by deformation, as a share of its length. */
  protected double deformationShare() {
    return ObjectRelations.GAP_SHARE;
  }

  /** Standard deviation of the difference of two objects' displacements, relative to them. */
  protected double unlikeShare() {
    return 1;
  }

  /** Log ratio of the densities of a box of one object and of one of several, nat, at most 0. */
  protected double oneLog(double lowXPx, double highXPx, double lowYPx) {
    return 0;
  }
}
