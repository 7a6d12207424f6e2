package haltere.filters.road;

import haltere.filters.object.ObjectTrack;
import haltere.filters.plane.PlaneJacobian;
import haltere.filters.plane.PlaneMapping;
import haltere.filters.plane.PlanePoint;
import java.util.Objects;
import java.util.Optional;

/**
 * Maps objects in the picture to a plane in the scene. A camera that looks along the plane sees an
 * object stand on it where its extent is lowest in the picture: the edge nearest to the camera, at
 * the ground. One that looks down sees its middle. The velocity is that of this point, and
 * covariances are mapped to first order (J C Jᵀ).
 *
 * <p>Thread rule: immutable.
 */
public final class ObjectsOnPlane {
  private final PlaneMapping mapping;
  private final boolean isAlong;

  private ObjectsOnPlane(PlaneMapping mapping, boolean isAlong) {
    this.mapping = Objects.requireNonNull(mapping, "mapping");
    this.isAlong = isAlong;
  }

  /**
   * For a camera that looks along the plane, such as along a road.
   *
   * @param mapping pixels to the plane
   * @return a map of objects by their lowest points
   */
  public static ObjectsOnPlane seenAlong(PlaneMapping mapping) {
    return new ObjectsOnPlane(mapping, true);
  }

  /**
   * For a camera that looks down on the plane, such as on an arena.
   *
   * @param mapping pixels to the plane
   * @return a map of objects by their middles
   */
  public static ObjectsOnPlane seenFromAbove(PlaneMapping mapping) {
    return new ObjectsOnPlane(mapping, false);
  }

  /**
   * Where an object is on the plane.
   *
   * @param track in the picture
   * @return empty where its point does not see the plane
   */
  public Optional<PlanePoint> locate(ObjectTrack track) {
    double along = track.majorPx() * Math.sin(track.angleRad());
    double across = track.minorPx() * Math.cos(track.angleRad());
    double x = track.xPx();
    double y = track.yPx() - (isAlong ? Math.hypot(along, across) : 0);
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
