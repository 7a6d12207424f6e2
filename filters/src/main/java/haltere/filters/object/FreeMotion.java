package haltere.filters.object;

import haltere.filters.estimation.GaussianState;

/**
 * The velocity is a random walk (white acceleration: Bar-Shalom, Li and Kirubarajan, Estimation
 * with Applications to Tracking and Navigation, 2001, eq. 6.2.2-12), scaled by the object's size.
 */
final class FreeMotion implements MotionModel {
  /**
   * Power spectral density of the acceleration, squares of its own size per s³: 2 σ²/τ where
   * velocities have a deviation σ and last for τ (Singer, IEEE TAES 6, 1970).
   */
  private static final double ACCELERATION =
      2 * BirthDetector.SPEED_SIZES_S * BirthDetector.SPEED_SIZES_S * Presence.STOP_HZ;

  /** Standard deviation of the rate at which an object turns, rad/s: half a turn a second. */
  private static final double TURN_RAD_S = Math.PI;

  @Override
  public void begin(GaussianState state) {
    // a birth has the prior of its size already
  }

  @Override
  public double predict(GaussianState state, double sizePx, double dtS) {
    // what is smaller than a cell of births moves as fast as what fills one
    double size = Math.max(sizePx, ClutterMap.CELL_PX);
    double q = ACCELERATION * size * size;
    for (int i = 0; i < 4; i += 2) {
      state.shear(i, i + 1, dtS);
      state.addNoise(i, q * dtS * dtS * dtS / 3);
      state.addNoise(i, i + 1, q * dtS * dtS / 2);
      state.addNoise(i + 1, q * dtS);
    }
    return 1;
  }

  @Override
  public boolean coasts() {
    return false;
  }

  @Override
  public double turnRadS() {
    return TURN_RAD_S;
  }

  @Override
  public double unlikeShare() {
    return 1;
  }

  @Override
  public double oneLog(double lowXPx, double highXPx, double lowYPx) {
    return 0;
  }
}
