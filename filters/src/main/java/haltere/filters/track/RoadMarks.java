package haltere.filters.track;

import haltere.core.event.SensorGeometry;
import java.util.List;
import java.util.Objects;

/**
 * What is marked on a road: where it vanishes, its lanes and the lines at which vehicles are
 * counted. Thread rule: immutable, may be used from any thread.
 *
 * @param mapping how the camera sees the road
 * @param sensor its pixels
 * @param lanes the lanes
 * @param lines the counting lines with their counts so far
 */
public record RoadMarks(
    RoadMapping mapping, SensorGeometry sensor, LaneSettings lanes, List<Line> lines) {
  /** Copies the list; nothing may be null. */
  public RoadMarks {
    Objects.requireNonNull(mapping, "mapping");
    Objects.requireNonNull(sensor, "sensor");
    Objects.requireNonNull(lanes, "lanes");
    lines = List.copyOf(lines);
  }

  /**
   * A counting line and who has crossed it, in all lanes and beside them.
   *
   * @param distanceM distance along the road, metres
   * @param away vehicles that have crossed it away from the camera
   * @param towards vehicles that have crossed it towards the camera
   */
  public record Line(double distanceM, long away, long towards) {}
}
