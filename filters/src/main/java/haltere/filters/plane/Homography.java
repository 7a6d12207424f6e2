package haltere.filters.plane;

import java.util.List;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * The perspective map of a plane that four pixels with known positions determine: R. Hartley and A.
 * Zisserman (2004), "Multiple View Geometry in Computer Vision", eq. 4.2 with h₃₃ = 1.
 *
 * <pre>
 *   x = (h₁ u + h₂ v + h₃) / w     y = (h₄ u + h₅ v + h₆) / w     w = h₇ u + h₈ v + 1
 * </pre>
 *
 * <p>(u, v) are pixels from the first of the four points. Pixels with w ≤ 0 are beyond the horizon
 * of the plane. Units on the plane are those of the points.
 */
public final class Homography implements PlaneMapping {
  /** Smallest area of a triangle of three of the points, as a share of the extent squared. */
  private static final double MIN_AREA = 1e-6;

  private final double originX;
  private final double originY;
  private final DMatrixRMaj forward = new DMatrixRMaj(3, 3);
  private final DMatrixRMaj backward = new DMatrixRMaj(3, 3);

  /** The Jacobian, where it is the same everywhere; else null. */
  private final PlaneJacobian constant;

  /** The identity. */
  Homography() {
    originX = 0;
    originY = 0;
    CommonOps_DDRM.setIdentity(forward);
    CommonOps_DDRM.setIdentity(backward);
    constant = new PlaneJacobian(1, 0, 0, 1);
  }

  /**
   * The map through four points.
   *
   * @param points four pixels and their positions, no three collinear, all on the same side of the
   *     horizon
   * @throws IllegalArgumentException if they determine no such map
   */
  public Homography(List<PointPair> points) {
    if (points.size() != 4) {
      throw new IllegalArgumentException("a plane needs four points, not " + points.size());
    }
    requireQuadrangle("pixels", points, true);
    requireQuadrangle("positions", points, false);
    constant = null;
    originX = points.get(0).xPx();
    originY = points.get(0).yPx();
    DMatrixRMaj equations = new DMatrixRMaj(8, 8);
    DMatrixRMaj positions = new DMatrixRMaj(8, 1);
    for (int i = 0; i < 4; i++) {
      PointPair point = points.get(i);
      addRow(equations, 2 * i, 0, point, point.x());
      addRow(equations, 2 * i + 1, 3, point, point.y());
      positions.set(2 * i, point.x());
      positions.set(2 * i + 1, point.y());
    }
    DMatrixRMaj h = new DMatrixRMaj(8, 1);
    boolean solved = CommonOps_DDRM.solve(equations, positions, h);
    System.arraycopy(h.data, 0, forward.data, 0, 8);
    forward.set(2, 2, 1);
    // w is 1 at the first point, so it is positive on the visible side of the horizon.
    if (!solved
        || !CommonOps_DDRM.invert(forward, backward)
        || !points.stream().allMatch(point -> seesPlane(point.xPx(), point.yPx()))) {
      throw new IllegalArgumentException("the four pairs of points have no homography of a camera");
    }
  }

  private void addRow(DMatrixRMaj rows, int row, int from, PointPair point, double position) {
    double u = point.xPx() - originX;
    double v = point.yPx() - originY;
    rows.set(row, from, u);
    rows.set(row, from + 1, v);
    rows.set(row, from + 2, 1);
    rows.set(row, 6, -u * position);
    rows.set(row, 7, -v * position);
  }

  private static void requireQuadrangle(String what, List<PointPair> points, boolean pixels) {
    double[] x = points.stream().mapToDouble(p -> pixels ? p.xPx() : p.x()).toArray();
    double[] y = points.stream().mapToDouble(p -> pixels ? p.yPx() : p.y()).toArray();
    for (int i = 0; i < 4; i++) {
      int j = (i + 1) % 4;
      int k = (i + 2) % 4;
      double area = (x[j] - x[i]) * (y[k] - y[i]) - (x[k] - x[i]) * (y[j] - y[i]);
      double extent = Math.hypot(x[j] - x[i], y[j] - y[i]) + Math.hypot(x[k] - x[i], y[k] - y[i]);
      if (!(Math.abs(area) > MIN_AREA * extent * extent)) {
        throw new IllegalArgumentException("three of the four " + what + " are on a line");
      }
    }
  }

  private static double row(DMatrixRMaj matrix, int row, double x, double y) {
    return matrix.get(row, 0) * x + matrix.get(row, 1) * y + matrix.get(row, 2);
  }

  private double depth(double xPx, double yPx) {
    return row(forward, 2, xPx - originX, yPx - originY);
  }

  private double plane(int row, double xPx, double yPx) {
    return row(forward, row, xPx - originX, yPx - originY) / depth(xPx, yPx);
  }

  @Override
  public boolean seesPlane(double xPx, double yPx) {
    return depth(xPx, yPx) > 0;
  }

  @Override
  public boolean isSeen(double x, double y) {
    // (u, v, 1) w⁻¹ = H⁻¹ (x, y, 1): the third entry is 1 / w.
    return row(backward, 2, x, y) > 0;
  }

  @Override
  public double planeX(double xPx, double yPx) {
    return plane(0, xPx, yPx);
  }

  @Override
  public double planeY(double xPx, double yPx) {
    return plane(1, xPx, yPx);
  }

  @Override
  public double pixelX(double x, double y) {
    return originX + row(backward, 0, x, y) / row(backward, 2, x, y);
  }

  @Override
  public double pixelY(double x, double y) {
    return originY + row(backward, 1, x, y) / row(backward, 2, x, y);
  }

  @Override
  public PlaneJacobian jacobian(double xPx, double yPx) {
    if (constant != null) {
      return constant;
    }
    double perDepth = 1 / depth(xPx, yPx);
    double x = planeX(xPx, yPx);
    double y = planeY(xPx, yPx);
    return new PlaneJacobian(
        perDepth * (forward.get(0, 0) - x * forward.get(2, 0)),
        perDepth * (forward.get(0, 1) - x * forward.get(2, 1)),
        perDepth * (forward.get(1, 0) - y * forward.get(2, 0)),
        perDepth * (forward.get(1, 1) - y * forward.get(2, 1)));
  }
}
