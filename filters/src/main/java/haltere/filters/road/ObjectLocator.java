package haltere.filters.road;

import haltere.filters.object.ObjectTrack;
import haltere.filters.plane.PlanePoint;
import java.util.Optional;

/** Tells where objects of the picture are on a plane in the scene. */
@FunctionalInterface
public interface ObjectLocator {
  /**
   * Where an object is.
   *
   * @param track a row; those of one object come in the order of their times
   * @return its place on the plane, empty where that is not known
   */
  Optional<PlanePoint> locate(ObjectTrack track);
}
