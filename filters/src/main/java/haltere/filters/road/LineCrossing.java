package haltere.filters.road;

import haltere.core.sink.Column;

/**
 * A track has crossed a counting line.
 *
 * @param timeUs time of the crossing on the clock of the events, microseconds
 * @param id identity of the track
 * @param lineM distance of the line along the road, metres
 * @param direction direction of the crossing
 * @param lane lane from the left, from 0; −1 beside the lanes
 * @param speedKmH speed, kilometres an hour
 * @param sdSpeedKmH standard deviation of the speed, kilometres an hour
 * @param countAway crossings of this line in this lane away from the camera, this one included
 * @param countTowards crossings of this line in this lane towards the camera, this one included
 */
public record LineCrossing(
    @Column("t_us") long timeUs,
    int id,
    @Column(decimals = 3) double lineM,
    Direction direction,
    int lane,
    @Column(decimals = 3) double speedKmH,
    @Column(decimals = 3) double sdSpeedKmH,
    long countAway,
    long countTowards) {
  /** Directions along a road. */
  public enum Direction {
    /** Away from the camera. */
    AWAY,
    /** Towards the camera. */
    TOWARDS
  }
}
