package haltere.filters.object;

import haltere.filters.estimation.GaussianState;

/**
 * What is known of how objects move and how large they are, before any is seen. States are (x, vx,
 * y, vy) in pixels.
 *
 * <p>Thread rule: implementations are used by one thread at a time.
 */
public interface MotionModel {
  /** Objects of any size that move as they like. */
  MotionModel FREE = new FreeMotion();

  /**
   * Takes the prior of the velocity into a state that has just been measured for the first time.
   *
   * @param state position and velocity, pixels and px/s
   */
  void begin(GaussianState state);

  /**
   * Predicts a state.
   *
   * @param state position and velocity, pixels and px/s
   * @param sizePx longer side of what is at the position
   * @param dtS how far, seconds
   * @return factor by which what is seen there grows meanwhile
   */
  double predict(GaussianState state, double sizePx, double dtS);

  /**
   * Whether an object that makes no events goes on, and does not come back once it left.
   *
   * @return false if it is taken to rest where it was
   */
  boolean coasts();

  /**
   * Standard deviation of the rate at which an object turns.
   *
   * @return rad/s
   */
  double turnRadS();

  /**
   * How unlike the motions of two objects are.
   *
   * @return standard deviation of the difference of two displacements, as a share of them
   */
  double unlikeShare();

  /**
   * Log ratio of the densities of a box of one object and of one that holds several.
   *
   * @param lowXPx left side, pixels
   * @param highXPx right side
   * @param lowYPx lower side
   * @return nat, at most 0
   */
  double oneLog(double lowXPx, double highXPx, double lowYPx);
}
