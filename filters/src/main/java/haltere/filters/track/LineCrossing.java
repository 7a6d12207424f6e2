package haltere.filters.track;

import haltere.core.sink.Column;

/**
 * A vehicle has crossed a counting line. Crossings are told as they are found out, which is not
 * always in the order of their times: what comes from far away may be found when it is beyond a
 * line already.
 *
 * @param timeUs when, on the clock of the events, microseconds; found once the vehicle is clear of
 *     the line, so it lies some way back
 * @param id identity of the track
 * @param lineM distance of the line along the road, metres
 * @param direction which way it went
 * @param lane lane from the left, from 0; −1 beside the lanes
 * @param speedKmH speed, kilometres an hour
 * @param sdSpeedKmH standard deviation of the speed, kilometres an hour
 * @param countAway vehicles that have crossed this line in this lane away from the camera, this one
 *     included if it did
 * @param countTowards the same of those that came towards it
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
  /** Ways to go on a road. */
  public enum Direction {
    /** Away from the camera. */
    AWAY,
    /** Towards the camera. */
    TOWARDS
  }
}
