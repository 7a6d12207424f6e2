package haltere.filters.object;

import haltere.core.sink.Column;
import haltere.filters.trail.TrailPoint;

/**
 * State of an object at one time: position, velocity and extent with standard deviations. The
 * position is the middle of the extent.
 *
 * @param timeUs time on the clock of the events, microseconds
 * @param id identity, from 1; never reused by one filter
 * @param xPx column, pixels from the left
 * @param yPx row, pixels from the bottom
 * @param vxPxS velocity along the columns, px/s
 * @param vyPxS velocity along the rows, px/s
 * @param sdXPx standard deviation of the column, pixels, with the deformation of the object
 * @param sdYPx standard deviation of the row, pixels, with the deformation of the object
 * @param sdVxPxS standard deviation of the velocity along the columns, px/s
 * @param sdVyPxS standard deviation of the velocity along the rows, px/s
 * @param events events assigned to it so far, each pixel at most once in 10 ms
 * @param majorPx longer half axis of its extent, pixels: two standard deviations
 * @param minorPx shorter half axis, pixels
 * @param angleRad direction of the longer axis against the columns, radians modulo π
 * @param existence probability that it is there, 0 to 1
 * @param eventRateHz present event rate, each pixel at most once in 10 ms
 * @param ageS time since its first events, seconds
 * @param lowYPx row of its lower edge, where a row has half of its usual number of events, pixels
 */
public record ObjectTrack(
    @Column("t_us") long timeUs,
    int id,
    @Column(decimals = 3) double xPx,
    @Column(decimals = 3) double yPx,
    @Column(value = "vx_px_s", decimals = 3) double vxPxS,
    @Column(value = "vy_px_s", decimals = 3) double vyPxS,
    @Column(decimals = 3) double sdXPx,
    @Column(decimals = 3) double sdYPx,
    @Column(value = "sd_vx_px_s", decimals = 3) double sdVxPxS,
    @Column(value = "sd_vy_px_s", decimals = 3) double sdVyPxS,
    long events,
    @Column(decimals = 3) double majorPx,
    @Column(decimals = 3) double minorPx,
    @Column(decimals = 4) double angleRad,
    @Column(decimals = 4) double existence,
    @Column(decimals = 1) double eventRateHz,
    @Column(decimals = 3) double ageS,
    @Column(decimals = 3) double lowYPx)
    implements TrailPoint {
  /** The same with an identity. */
  ObjectTrack withId(int decided) {
    return new ObjectTrack(
        timeUs,
        decided,
        xPx,
        yPx,
        vxPxS,
        vyPxS,
        sdXPx,
        sdYPx,
        sdVxPxS,
        sdVyPxS,
        events,
        majorPx,
        minorPx,
        angleRad,
        existence,
        eventRateHz,
        ageS,
        lowYPx);
  }
}
