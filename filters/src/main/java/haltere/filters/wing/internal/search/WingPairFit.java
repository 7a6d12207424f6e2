package haltere.filters.wing.internal.search;

import java.util.Arrays;

/**
 * Adjusts the fits of both wings with two priors: the hinges are opposite each other across the
 * body line, and both strokes have the same centre. Where the events of a wing leave its hinge,
 * centre and the heading undetermined, the other wing determines them (least squares over the
 * normal equations of both fits and the priors).
 */
final class WingPairFit {
  private static final int TURN = 2 * StrokeFit.SIZE;
  private static final int SIZE = TURN + 1;
  private static final int ROUNDS = 4;

  /** Number of events of one beat that count as one, since their errors are correlated. */
  private static final double REPEATING = 3;

  /** Offset of the hinges along the body. */
  private static final double HINGES_SD_PX = 0.3;

  /** Half of the difference of the centres. */
  private static final double SYMMETRY_SD_RAD = 0.03;

  /** Angle between body line and common direction of the wings. */
  private static final double TURN_SD_RAD = 0.5;

  private final NormalEquations normal = new NormalEquations(SIZE);
  private final double[] row = new double[SIZE];
  private final double[] moved = new double[SIZE];

  /** Rotation of the heading against the axis of the fits. */
  double turnRad;

  /**
   * Adjusts both fits, the wing counterclockwise of the axis first. False without a change if the
   * equations have no solution.
   */
  boolean adjust(StrokeFit[] fits, double axisRad) {
    Arrays.fill(moved, 0);
    for (int round = 0; round < ROUNDS; round++) {
      if (!improve(fits, axisRad)) {
        return false;
      }
    }
    turnRad = moved[TURN];
    for (int side = 0; side < 2; side++) {
      for (int i = 0; i < StrokeFit.SIZE; i++) {
        fits[side].p[i] += moved[side * StrokeFit.SIZE + i];
      }
    }
    return true;
  }

  private boolean improve(StrokeFit[] fits, double axisRad) {
    normal.clear();
    for (int side = 0; side < 2; side++) {
      fits[side].addTo(normal, side * StrokeFit.SIZE, REPEATING);
    }
    normal.addPrior(TURN, 0, TURN_SD_RAD);
    addSymmetryPrior(fits);
    addHingePrior(fits, axisRad + moved[TURN]);
    return normal.solve(SIZE, moved);
  }

  private void addSymmetryPrior(StrokeFit[] fits) {
    Arrays.fill(row, 0);
    row[StrokeFit.CENTRE] = 0.5;
    row[StrokeFit.SIZE + StrokeFit.CENTRE] = -0.5;
    row[TURN] = -1;
    addPrior((fits[0].centre() - fits[1].centre()) / 2, SYMMETRY_SD_RAD);
  }

  private void addHingePrior(StrokeFit[] fits, double heading) {
    int other = StrokeFit.SIZE;
    double cos = Math.cos(heading);
    double sin = Math.sin(heading);
    double x = fits[0].hingeX() - fits[1].hingeX();
    double y = fits[0].hingeY() - fits[1].hingeY();
    double nowX = x + moved[StrokeFit.HINGE_X] - moved[other + StrokeFit.HINGE_X];
    double nowY = y + moved[StrokeFit.HINGE_Y] - moved[other + StrokeFit.HINGE_Y];
    Arrays.fill(row, 0);
    row[StrokeFit.HINGE_X] = cos;
    row[StrokeFit.HINGE_Y] = sin;
    row[other + StrokeFit.HINGE_X] = -cos;
    row[other + StrokeFit.HINGE_Y] = -sin;
    row[TURN] = nowY * cos - nowX * sin;
    // the value at the fits themselves, by the slope where the fits are moved to
    addPrior(x * cos + y * sin - row[TURN] * moved[TURN], HINGES_SD_PX);
  }

  /** Adds the prior that a value with the derivatives {@link #row} is 0 within a deviation. */
  private void addPrior(double value, double sd) {
    normal.add(1 / (sd * sd), row, SIZE, -value);
  }
}
