package haltere.core.simulation.internal.road;

/**
 * A part of a vehicle: a box with paint on the three kinds of faces that can be seen. Positions are
 * relative to the vehicle: across from its middle, along from its end that is nearer to the camera.
 *
 * <p>Thread rule: immutable once painted.
 */
final class PaintedBox {
  static final int NEAR = 0;
  static final int TOP = 1;
  static final int SIDE = 2;
  static final int FACES = 3;
  static final int COLUMNS = 8;
  static final int ROWS = 4;
  static final double NOWHERE = Double.POSITIVE_INFINITY;

  final double left;
  final double right;
  final double near;
  final double far;
  final double bottom;
  final double top;
  private final double[] light = new double[FACES * ROWS * COLUMNS];

  PaintedBox(double left, double right, double near, double far, double bottom, double top) {
    this.left = left;
    this.right = right;
    this.near = near;
    this.far = far;
    this.bottom = bottom;
    this.top = top;
  }

  /**
   * Paints a patch of a face. Columns run across, on a side along; rows run up, on the top along.
   */
  PaintedBox paint(int face, int fromColumn, int toColumn, int fromRow, int toRow, double value) {
    for (int row = fromRow; row <= toRow; row++) {
      for (int column = fromColumn; column <= toColumn; column++) {
        light[(face * ROWS + row) * COLUMNS + column] = value;
      }
    }
    return this;
  }

  PaintedBox paintAll(int face, double value) {
    return paint(face, 0, COLUMNS - 1, 0, ROWS - 1, value);
  }

  /** Light at the middle of a patch. */
  double paintAt(int face, int column, int row) {
    return light[(face * ROWS + row) * COLUMNS + column];
  }

  /**
   * Slant range at which a ray enters the box.
   *
   * @param x middle of the vehicle across the road
   * @param d its nearer end
   * @return slant range, or {@link #NOWHERE}
   */
  double intersect(double x, double d, Ray ray) {
    return intersectAcross(x, enter(d, ray), leave(d, ray), ray);
  }

  /** Slant range at which a ray enters the box's extent along and up, whatever its column. */
  double enter(double d, Ray ray) {
    double along = (d + (ray.inverseCos > 0 ? near : far)) * ray.inverseCos;
    return Math.max(along, (ray.heightM - top) * ray.inverseSin);
  }

  /** Slant range at which a ray leaves the box's extent along and up, whatever its column. */
  double leave(double d, Ray ray) {
    double along = (d + (ray.inverseCos > 0 ? far : near)) * ray.inverseCos;
    return Math.min(along, (ray.heightM - bottom) * ray.inverseSin);
  }

  /** Slant range at which a ray enters the box, given {@link #enter} and {@link #leave}. */
  double intersectAcross(double x, double alongEnter, double alongLeave, Ray ray) {
    double toLeft = (x + left) * ray.inverseTangent;
    double toRight = (x + right) * ray.inverseTangent;
    double enter = Math.max(alongEnter, Math.min(toLeft, toRight));
    double leave = Math.min(alongLeave, Math.max(toLeft, toRight));
    return enter > leave || enter < 0 ? NOWHERE : enter;
  }

  /** Light where a ray meets the box at a slant range that {@link #intersect} gave. */
  double lightAt(double x, double d, Ray ray, double range) {
    double across = (ray.tangent * range - x - left) / (right - left);
    double along = (range / ray.inverseCos - d - near) / (far - near);
    double up = top > bottom ? (ray.heightM - range / ray.inverseSin - bottom) / (top - bottom) : 1;
    double fromTop = (ray.heightM - top) * ray.inverseSin;
    double fromNear = (d + near) * ray.inverseCos;
    if (range <= fromTop) {
      return paintAt(TOP, cell(across, COLUMNS), cell(along, ROWS));
    }
    if (range <= fromNear) {
      return paintAt(NEAR, cell(across, COLUMNS), cell(up, ROWS));
    }
    return paintAt(SIDE, cell(along, COLUMNS), cell(up, ROWS));
  }

  private static int cell(double share, int cells) {
    return Math.max(0, Math.min(cells - 1, (int) (share * cells)));
  }

  /**
   * The line of sight of a pixel, see {@link RoadCamera}. Rays at and above the horizon meet
   * nothing.
   */
  static final class Ray {
    final double heightM;
    double tangent;
    double inverseTangent;
    double inverseCos;
    double inverseSin;

    Ray(double heightM) {
      this.heightM = heightM;
    }
  }
}
