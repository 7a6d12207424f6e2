package haltere.filters.wing.internal.search;

import java.util.Arrays;

/**
 * Brings the fits of both wings together: a fly's hinges are across its body line from each other,
 * and its wings stroke about the same centre on both sides. What a wing's events do not tell of its
 * own hinge, the other's do: the hinge along the body, the centre and the heading go together, and
 * all are moved by as much as their fits leave them free (least squares over both fits' normal
 * equations and the two beliefs).
 */
final class WingPairFit {
  private static final int TURN = 2 * StrokeFit.SIZE;
  private static final int SIZE = TURN + 1;
  private static final int ROUNDS = 4;

  /** Events of one beat repeat each other's errors: so many of them count for one. */
  private static final double REPEATING = 3;

  /** How far one hinge is before the other. */
  private static final double HINGES_SD_PX = 0.3;

  /** Half of what the centres of both strokes differ by. */
  private static final double SYMMETRY_SD_RAD = 0.03;

  /** How far the body line is from the direction in which the wings swing together. */
  private static final double TURN_SD_RAD = 0.5;

  private final NormalEquations normal = new NormalEquations(SIZE);
  private final double[] row = new double[SIZE];
  private final double[] moved = new double[SIZE];

  /** By how much the heading is turned against the axis of the fits. */
  double turnRad;

  /**
   * Moves both fits, that of the wing counterclockwise of the axis first, to where they go
   * together. False if the equations have no solution; nothing is moved then.
   */
  boolean bring(StrokeFit[] fits, double axisRad) {
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
    normal.believe(TURN, 0, TURN_SD_RAD);
    believeInSymmetry(fits);
    believeInHinges(fits, axisRad + moved[TURN]);
    return normal.solve(SIZE, moved);
  }

  private void believeInSymmetry(StrokeFit[] fits) {
    Arrays.fill(row, 0);
    row[StrokeFit.CENTRE] = 0.5;
    row[StrokeFit.SIZE + StrokeFit.CENTRE] = -0.5;
    row[TURN] = -1;
    believe((fits[0].centre() - fits[1].centre()) / 2, SYMMETRY_SD_RAD);
  }

  private void believeInHinges(StrokeFit[] fits, double heading) {
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
    believe(x * cos + y * sin - row[TURN] * moved[TURN], HINGES_SD_PX);
  }

  /** That a value, which {@link #row} has the derivatives of, is 0 within a standard deviation. */
  private void believe(double value, double sd) {
    normal.add(1 / (sd * sd), row, SIZE, -value);
  }
}
