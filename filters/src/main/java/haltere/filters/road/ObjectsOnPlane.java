package haltere.filters.road;

import haltere.filters.object.ObjectTrack;
import haltere.filters.plane.PlaneJacobian;
import haltere.filters.plane.PlaneMapping;
import haltere.filters.plane.PlanePoint;
import java.util.Objects;
import java.util.Optional;

/**
 * Maps objects in the picture to a plane in the scene. An object stands on the plane where its
 * extent is lowest in the picture: the edge nearest to the camera, at the ground. The velocity is
 * that of this point, and covariances are mapped to first order (J C Jᵀ).
 *
 * <p>Thread rule: immutable.
 */
public final class ObjectsOnPlane {
  private final PlaneMapping mapping;

  /**
   * A map of objects.
   *
   * @param mapping pixels to the plane
   */
  public ObjectsOnPlane(PlaneMapping mapping) {
    this.mapping = Objects.requireNonNull(mapping, "mapping");
  }

  /**
   * Where an object is on the plane.
   *
   * @param track in the picture
   * @return empty where its lowest point does not see the plane
   */
  public Optional<PlanePoint> locate(ObjectTrack track) {
    double along = track.majorPx() * Math.sin(track.angleRad());
    double across = track.minorPx() * Math.cos(track.angleRad());
    double x = track.xPx();
    double y = track.yPx() - Math.hypot(along, across);
    if (!mapping.seesPlane(x, y)) {
      return Optional.empty();
    }
    PlaneJacobian j = mapping.jacobian(x, y);
    double xx = track.sdXPx() * track.sdXPx();
    double yy = track.sdYPx() * track.sdYPx();
    double vxx = track.sdVxPxS() * track.sdVxPxS();
    double vyy = track.sdVyPxS() * track.sdVyPxS();
    return Optional.of(
        new PlanePoint(
            track.timeUs(),
            track.id(),
            mapping.planeX(x, y),
            mapping.planeY(x, y),
            j.x(track.vxPxS(), track.vyPxS()),
            j.y(track.vxPxS(), track.vyPxS()),
            Math.sqrt(j.xx(xx, 0, yy)),
            Math.sqrt(j.yy(xx, 0, yy)),
            Math.sqrt(j.xx(vxx, 0, vyy)),
            Math.sqrt(j.yy(vxx, 0, vyy))));
  }
}
