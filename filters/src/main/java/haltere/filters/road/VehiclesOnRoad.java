package haltere.filters.road;

import haltere.filters.object.ObjectTrack;
import haltere.filters.plane.PlanePoint;
import haltere.filters.plane.RoadMapping;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Function;

/**
 * Maps the objects of a camera that looks along a road to vehicles: position and velocity of the
 * nearer end, from rows up to the present one. Rows of one object must be in order of time. The
 * result is empty until the extent of the vehicle is known.
 *
 * <p>Thread rule: not safe for use by two threads at a time.
 */
public final class VehiclesOnRoad implements Function<ObjectTrack, Optional<PlanePoint>> {
  private final RoadMapping mapping;
  private final VehiclePrior prior;
  private final Map<Integer, Vehicle> vehicles = LineCounter.recent();

  /**
   * A road without vehicles.
   *
   * @param mapping pixels to the road
   * @param prior prior of vehicles
   */
  public VehiclesOnRoad(RoadMapping mapping, VehiclePrior prior) {
    this.mapping = Objects.requireNonNull(mapping, "mapping");
    this.prior = Objects.requireNonNull(prior, "prior");
  }

  @Override
  public Optional<PlanePoint> apply(ObjectTrack track) {
    return vehicles
        .computeIfAbsent(track.id(), id -> new Vehicle(mapping, prior, track.timeUs()))
        .update(track);
  }
}
