package haltere.filters.track.road;

import haltere.filters.track.motion.MotionModes;

/**
 * A line across the road that a {@link LineSearch} has found, as it is at the time of the search.
 *
 * <p>Thread rule: that of the search, which writes to it.
 */
public final class FoundLine {
  /** A line is found by this many rows at least. */
  static final int LEAST_ROWS = 3;

  /** By how much of its standard deviation a line of so few rows is less sure. */
  private static final double ROW_DOUBT = 2;

  /** How well it is known where the middle of a line is that was found, m². */
  private static final double VARIANCE_X = 0.1;

  /** How fast a vehicle may be across the road, standard deviation. */
  private static final double LATERAL_SD_M_S = 1.5;

  /** Of the place of a vehicle whose other line is seen from now on, m². */
  private static final double PLACE_VARIANCE = 25;

  double xM;
  double yM;
  double vyMS;
  double varianceY;
  double covarianceYvy;
  double varianceVy;
  double halfWidthM;
  double seenHalfM;

  /** How many rows tell of it. */
  int rows;

  boolean isCut;
  boolean isOn;
  int lastRow;
  double lastColumn;

  FoundLine() {}

  /**
   * Lets a motion begin with it: its place and its speed along the road are known.
   *
   * @param motion on the road, in metres
   */
  public void launch(MotionModes motion) {
    double more = doubt();
    motion.launch(xM, yM, VARIANCE_X, 0, more * varianceY, LATERAL_SD_M_S * LATERAL_SD_M_S);
    motion.setAlong(vyMS, more * covarianceYvy, more * varianceVy);
  }

  /**
   * Lets a motion go on with it as another line of the same vehicle, which tells of its speed too.
   *
   * @param motion on the road, in metres
   */
  public void rejoin(MotionModes motion) {
    motion.shift(0, PLACE_VARIANCE);
    if (!Double.isNaN(motion.innovate(xM, yM, VARIANCE_X, 0, varianceY))) {
      motion.correct();
    }
    motion.correctAlong(vyMS, doubt() * varianceVy);
  }

  /**
   * By how much the variances are larger than the fit to the rows says: of few rows one may have
   * been passed by another line, which the fit does not know of.
   */
  private double doubt() {
    double few = (double) LEAST_ROWS / rows;
    double doubt = 1 + ROW_DOUBT * few * few;
    return doubt * doubt;
  }

  /**
   * Where its middle is across the road.
   *
   * @return metres to the right
   */
  public double xM() {
    return xM;
  }

  /**
   * Where it is along the road.
   *
   * @return metres ahead
   */
  public double yM() {
    return yM;
  }

  /**
   * How fast it is along the road.
   *
   * @return metres a second, positive away from the camera
   */
  public double vyMS() {
    return vyMS;
  }

  /**
   * How sure its place along the road is, by the fit to its rows.
   *
   * @return variance, m²
   */
  public double varianceY() {
    return varianceY;
  }

  /**
   * How sure its speed is, by the fit to its rows.
   *
   * @return variance, m²/s²
   */
  public double varianceVy() {
    return varianceVy;
  }

  /**
   * How wide it is, with what the side of the picture may hide of it.
   *
   * @return half of its width, metres
   */
  public double halfWidthM() {
    return halfWidthM;
  }

  /**
   * How wide what is seen of it is.
   *
   * @return half of the width, metres
   */
  public double seenHalfM() {
    return seenHalfM;
  }

  /**
   * Whether the side of the picture hides a part of it.
   *
   * @return true if so
   */
  public boolean isCut() {
    return isCut;
  }

  /**
   * Polarity of its events.
   *
   * @return true if the road becomes brighter where it passes
   */
  public boolean isOn() {
    return isOn;
  }

  /**
   * The row that it has passed last.
   *
   * @return row of the picture
   */
  public int lastRow() {
    return lastRow;
  }

  /**
   * The column of its middle in that row.
   *
   * @return column of the picture
   */
  public double lastColumn() {
    return lastColumn;
  }
}
