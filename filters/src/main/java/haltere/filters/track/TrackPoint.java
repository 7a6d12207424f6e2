package haltere.filters.track;

import haltere.core.sink.Column;
import haltere.filters.trail.TrailPoint;

/**
 * State of a track at one time, from events before that time only.
 *
 * @param timeUs time on the clock of the events, microseconds
 * @param id identity of the track, from 1, never reused
 * @param xPx column, pixels
 * @param yPx row, pixels upwards
 * @param vxPxS velocity to the right, pixels a second
 * @param vyPxS velocity upwards, pixels a second
 * @param sdXPx standard deviation of the column, pixels
 * @param sdYPx standard deviation of the row, pixels
 * @param sdVxPxS standard deviation of the velocity to the right, pixels a second
 * @param sdVyPxS standard deviation of the velocity upwards, pixels a second
 * @param events events of the track since its start
 */
public record TrackPoint(
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
    long events)
    implements TrailPoint {}
