package haltere.filters.road;

import haltere.filters.object.ObjectTrack;
import haltere.filters.plane.PlaneJacobian;
import haltere.filters.plane.PlaneMapping;
import haltere.filters.plane.PlanePoint;
import java.util.Optional;
import java.util.function.Function;

/**
 * Maps objects seen from above to their plane, such as an arena: the position is the middle of the
 * extent. Covariances are mapped to the first order (J C Jᵀ). The result is empty where the middle
 * does not see the plane. For a camera that looks along a road: {@link VehiclesOnRoad}.
 *
 * <p>Thread rule: immutable.
 *
 * @param mapping pixels to the plane
 */
public record ObjectsOnPlane(PlaneMapping mapping)
    implements Function<ObjectTrack, Optional<PlanePoint>> {
  @Override
  public Optional<PlanePoint> apply(ObjectTrack track) {
    double x = track.xPx();
    double y = track.yPx();
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
