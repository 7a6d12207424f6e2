package haltere.filters.orientation.camera;

/**
 * Vectors of three numbers and 3 x 3 matrices of nine numbers, row by row. Only methods that return
 * an array allocate; any thread.
 */
public final class Vectors {
  private Vectors() {}

  /**
   * The scalar product.
   *
   * @param a three numbers
   * @param b three numbers
   * @return a · b
   */
  public static double dot(double[] a, double[] b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  /**
   * The length.
   *
   * @param a three numbers
   * @return |a|
   */
  public static double length(double[] a) {
    return Math.sqrt(dot(a, a));
  }

  /**
   * The vector product.
   *
   * @param a three numbers
   * @param b three numbers
   * @param out receives a × b; may be one of the two
   */
  public static void cross(double[] a, double[] b, double[] out) {
    double x = a[1] * b[2] - a[2] * b[1];
    double y = a[2] * b[0] - a[0] * b[2];
    double z = a[0] * b[1] - a[1] * b[0];
    out[0] = x;
    out[1] = y;
    out[2] = z;
  }

  /**
   * Normalises a vector.
   *
   * @param a three numbers; replaced
   * @return false, without a change, for a zero vector
   */
  public static boolean normalise(double[] a) {
    double length = length(a);
    if (!(length > 1e-300) || Double.isInfinite(length)) {
      return false;
    }
    a[0] /= length;
    a[1] /= length;
    a[2] /= length;
    return true;
  }

  /**
   * A multiple.
   *
   * @param factor any
   * @param a three numbers
   * @return factor a, a new array
   */
  public static double[] scaled(double factor, double[] a) {
    return new double[] {factor * a[0], factor * a[1], factor * a[2]};
  }

  /**
   * Any unit vector orthogonal to a unit vector.
   *
   * @param unit three numbers of length 1
   * @return a new array
   */
  public static double[] orthogonalTo(double[] unit) {
    double[] basis = new double[3];
    int axis = 0;
    for (int i = 1; i < 3; i++) {
      axis = Math.abs(unit[i]) < Math.abs(unit[axis]) ? i : axis;
    }
    basis[axis] = 1;
    double[] out = new double[3];
    cross(unit, basis, out);
    normalise(out);
    return out;
  }

  /**
   * The angle between two vectors, accurate near both ends.
   *
   * @param a three numbers
   * @param b three numbers
   * @return radians, 0 to pi
   */
  public static double angle(double[] a, double[] b) {
    double[] across = new double[3];
    cross(a, b, across);
    return Math.atan2(length(across), dot(a, b));
  }

  /**
   * The product of a 3 x 3 matrix and a vector.
   *
   * @param m nine numbers
   * @param v three numbers
   * @param out receives the product; another array than v
   */
  public static void multiply(double[] m, double[] v, double[] out) {
    for (int i = 0; i < 3; i++) {
      out[i] = m[3 * i] * v[0] + m[3 * i + 1] * v[1] + m[3 * i + 2] * v[2];
    }
  }
}
