package haltere.filters.orientation.camera;

import java.util.Arrays;
import java.util.Objects;
import java.util.Optional;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * A calibrated camera: a point X of the world is seen at (h₀/h₂, h₁/h₂), h = C (X, 1), with C the 3
 * x 4 matrix, then distorted by the lens.
 *
 * <p>A line on a body with the direction u is seen at the angle
 *
 * <pre>
 * θ = atan(n₁·u / n₀·u) (mod π),   n₀ = h₂ m₀ − h₀ m₂,   n₁ = h₂ m₁ − h₁ m₂
 * </pre>
 *
 * <p>with m the rows of the left 3 x 3 part of C: the derivative of the projection. Thread rule:
 * immutable.
 */
public final class CameraModel {
  /** Relative depth below which a point is in the plane of the camera's centre. */
  private static final double AT_CENTRE = 1e-9;

  private static final double DIFFERENCE_PX = 1e-3;

  private final String id;
  private final double[] matrix;
  private final double[] centre = new double[3];
  private final DMatrixRMaj inverse = new DMatrixRMaj(3, 3);
  private final Lens lens;
  private final int widthPx;
  private final int heightPx;
  private final String problem;

  private CameraModel(
      String id, double[] matrix, Lens lens, int widthPx, int heightPx, String problem) {
    this.id = id;
    this.matrix = matrix;
    this.lens = lens;
    this.widthPx = widthPx;
    this.heightPx = heightPx;
    this.problem = problem;
    if (problem == null) {
      invert();
    }
  }

  /**
   * A camera with a lens by its matrix and five numbers: the matrix is decomposed into a triangular
   * matrix with a positive diagonal and a rotation (which may mirror).
   *
   * @param id its name
   * @param matrix twelve numbers, row by row
   * @param distortion k1, k2, p1, p2, k3; empty for none
   * @param widthPx columns of its sensor, 0 if unknown
   * @param heightPx rows of its sensor, 0 if unknown
   * @return a camera; one with a degenerate matrix has a {@link #problem}
   */
  public static CameraModel of(
      String id, double[] matrix, double[] distortion, int widthPx, int heightPx) {
    if (distortion.length != 0 && distortion.length != 5) {
      throw new IllegalArgumentException(
          "distortion has " + distortion.length + " numbers, it must have k1, k2, p1, p2 and k3");
    }
    double[] d = distortion.length == 0 ? new double[5] : distortion;
    double[] own = normalised(matrix);
    String problem = problemOf(own);
    if (problem == null && !Double.isFinite(d[0] + d[1] + d[2] + d[3] + d[4])) {
      problem = "its distortion is not finite";
    }
    if (problem != null) {
      return new CameraModel(id, own, null, widthPx, heightPx, problem);
    }
    double[] m0 = left(own, 0);
    double[] m1 = left(own, 1);
    double[] r3 = left(own, 2);
    double cx = Vectors.dot(m0, r3);
    double cy = Vectors.dot(m1, r3);
    double[] r2 = {m1[0] - cy * r3[0], m1[1] - cy * r3[1], m1[2] - cy * r3[2]};
    double fy = Vectors.length(r2);
    Vectors.normalise(r2);
    double skew = Vectors.dot(m0, r2);
    double[] r1 = new double[3];
    for (int i = 0; i < 3; i++) {
      r1[i] = m0[i] - cx * r3[i] - skew * r2[i];
    }
    double fx = Vectors.length(r1);
    Lens lens = new Lens(fx, fy, skew, cx, cy, d[0], d[1], d[2], d[3], d[4]);
    return new CameraModel(id, own, lens, widthPx, heightPx, null);
  }

  /** A camera with a known lens; the matrix maps to undistorted pixels. */
  static CameraModel of(String id, double[] matrix, Lens lens, int widthPx, int heightPx) {
    double[] own = normalised(matrix);
    return new CameraModel(
        id, own, Objects.requireNonNull(lens, "lens"), widthPx, heightPx, problemOf(own));
  }

  /** The same camera with the third row of length 1, so that depth is in the world's unit. */
  private static double[] normalised(double[] matrix) {
    if (matrix.length != 12) {
      throw new IllegalArgumentException(
          "a camera matrix has 12 numbers (3 rows of 4), not " + matrix.length);
    }
    double[] own = matrix.clone();
    double scale = Vectors.length(left(own, 2));
    for (int i = 0; i < 12 && scale > 0; i++) {
      own[i] /= scale;
    }
    return own;
  }

  private static String problemOf(double[] m) {
    if (!Arrays.stream(m).allMatch(Double::isFinite)) {
      return "its matrix has entries that are not finite";
    }
    double[] m0 = left(m, 0);
    double[] m1 = left(m, 1);
    double[] m2 = left(m, 2);
    double[] across = new double[3];
    Vectors.cross(m0, m1, across);
    double volume = Math.abs(Vectors.dot(across, m2));
    double size = Vectors.length(m0) * Vectors.length(m1) * Vectors.length(m2);
    return volume > 1e-9 * size ? null : "the left part of its matrix has a rank of less than 3";
  }

  /** A row of the left part. */
  private static double[] left(double[] matrix, int row) {
    return Arrays.copyOfRange(matrix, 4 * row, 4 * row + 3);
  }

  private void invert() {
    CommonOps_DDRM.extract(DMatrixRMaj.wrap(3, 4, matrix), 0, 3, 0, 3, inverse);
    CommonOps_DDRM.invert(inverse);
    double[] last = {-matrix[3], -matrix[7], -matrix[11]};
    Vectors.multiply(inverse.data, last, centre);
  }

  /** {@return its name, as in the calibration} */
  public String id() {
    return id;
  }

  /** {@return why it cannot be used, or empty} */
  public Optional<String> problem() {
    return Optional.ofNullable(problem);
  }

  /** {@return the columns of its sensor, pixels, 0 if unknown} */
  public int widthPx() {
    return widthPx;
  }

  /** {@return the rows of its sensor, pixels, 0 if unknown} */
  public int heightPx() {
    return heightPx;
  }

  /** {@return its centre, metres; NaN for a camera with a problem} */
  public double[] centre() {
    return problem == null ? centre.clone() : new double[] {Double.NaN, Double.NaN, Double.NaN};
  }

  /** {@return its matrix row by row, with the third row's direction of length 1} */
  public double[] matrix() {
    return matrix.clone();
  }

  /**
   * Projects a point without lens distortion.
   *
   * @param point metres
   * @param pixel receives column and row
   * @return false if it has no projection: in the plane of the camera's centre
   */
  public boolean projectIdeal(double[] point, double[] pixel) {
    double h2 = row(2, point);
    double x = row(0, point) / h2;
    double y = row(1, point) / h2;
    if (problem != null || !(Math.abs(h2) > AT_CENTRE * reach(point)) || !Double.isFinite(x + y)) {
      return false;
    }
    pixel[0] = x;
    pixel[1] = y;
    return true;
  }

  /**
   * Projects a point with lens distortion.
   *
   * @param point metres
   * @param pixel receives column and row
   * @return false if it has no projection
   */
  public boolean project(double[] point, double[] pixel) {
    if (!projectIdeal(point, pixel)) {
      return false;
    }
    lens.distort(pixel);
    return Double.isFinite(pixel[0] + pixel[1]);
  }

  /**
   * Direction of an axis on a body in the picture, with lens distortion.
   *
   * @param point position of the body, metres
   * @param axis of any length but 0
   * @return radians from +x towards +y; NaN if it is undefined
   */
  public double heading(double[] point, double[] axis) {
    double[] n = new double[6];
    double[] pixel = new double[2];
    if (!lineNormals(point, n) || !projectIdeal(point, pixel)) {
      return Double.NaN;
    }
    double vx = Vectors.dot(n, axis);
    double vy = Vectors.dot(Arrays.copyOfRange(n, 3, 6), axis);
    double length = Math.hypot(vx, vy);
    if (!(length > 1e-12 * Vectors.length(axis))) {
      return Double.NaN;
    }
    // central difference of the lens along the line, with a negligible third order
    double stepX = DIFFERENCE_PX * vx / length;
    double stepY = DIFFERENCE_PX * vy / length;
    double[] ahead = {pixel[0] + stepX, pixel[1] + stepY};
    double[] behind = {pixel[0] - stepX, pixel[1] - stepY};
    lens.distort(ahead);
    lens.distort(behind);
    return Math.atan2(ahead[1] - behind[1], ahead[0] - behind[0]);
  }

  /**
   * The two vectors of a line's angle, tan θ = n₁·u / n₀·u, without lens distortion; scaled so that
   * the longer one is about 1.
   *
   * @param point position of the body, metres
   * @param n receives n₀ and n₁, six numbers
   * @return false if the angle is undefined: at the camera's centre or in its plane
   */
  public boolean lineNormals(double[] point, double[] n) {
    double h0 = row(0, point);
    double h1 = row(1, point);
    double h2 = row(2, point);
    if (problem != null || !(Math.abs(h2) > AT_CENTRE * reach(point))) {
      return false;
    }
    double[] m = matrix;
    double squares = 0;
    for (int i = 0; i < 3; i++) {
      n[i] = h2 * m[i] - h0 * m[8 + i];
      n[3 + i] = h2 * m[4 + i] - h1 * m[8 + i];
      squares += n[i] * n[i] + n[3 + i] * n[3 + i];
    }
    double scale = Math.sqrt(squares / 2);
    if (!(scale > 0) || Double.isInfinite(scale)) {
      return false;
    }
    for (int i = 0; i < 6; i++) {
      n[i] /= scale;
    }
    return true;
  }

  /**
   * The line of sight of an undistorted point of the picture.
   *
   * @param xPx column
   * @param yPx row
   * @param direction receives a unit vector of the world, to the front or to the back
   * @return false for a camera with a problem or a point that is not finite
   */
  public boolean lineOfSight(double xPx, double yPx, double[] direction) {
    if (problem != null) {
      return false;
    }
    Vectors.multiply(inverse.data, new double[] {xPx, yPx, 1}, direction);
    return Double.isFinite(direction[0] + direction[1] + direction[2])
        && Vectors.normalise(direction);
  }

  /**
   * Undistorts an observation.
   *
   * @param line column, row, angle (NaN for none); replaced
   * @return false outside the image of the lens, or with a problem
   */
  public boolean undistort(double[] line) {
    return problem == null && lens.undistort(line);
  }

  /**
   * The derivative of {@link #projectIdeal} by the point.
   *
   * @param point metres
   * @param pixel its undistorted projection
   * @param jacobian receives two rows of three
   */
  public void projectionJacobian(double[] point, double[] pixel, double[] jacobian) {
    double h2 = row(2, point);
    for (int k = 0; k < 3; k++) {
      jacobian[k] = (matrix[k] - pixel[0] * matrix[8 + k]) / h2;
      jacobian[3 + k] = (matrix[4 + k] - pixel[1] * matrix[8 + k]) / h2;
    }
  }

  private double row(int i, double[] point) {
    return matrix[4 * i] * point[0]
        + matrix[4 * i + 1] * point[1]
        + matrix[4 * i + 2] * point[2]
        + matrix[4 * i + 3];
  }

  private double reach(double[] point) {
    return 1e-3 + Vectors.length(point) + Vectors.length(centre);
  }
}
