package haltere.filters.plane;

/** The identity: the plane is the picture. */
final class PicturePlane implements PlaneMapping {
  private static final PlaneJacobian IDENTITY = new PlaneJacobian(1, 0, 0, 1);

  @Override
  public boolean seesPlane(double xPx, double yPx) {
    return isSeen(xPx, yPx);
  }

  @Override
  public boolean isSeen(double x, double y) {
    return !Double.isNaN(x + y);
  }

  @Override
  public double planeX(double xPx, double yPx) {
    return xPx;
  }

  @Override
  public double planeY(double xPx, double yPx) {
    return yPx;
  }

  @Override
  public double pixelX(double x, double y) {
    return x;
  }

  @Override
  public double pixelY(double x, double y) {
    return y;
  }

  @Override
  public PlaneJacobian jacobian(double xPx, double yPx) {
    return IDENTITY;
  }
}
