package haltere.filters.track;

import haltere.core.sink.Column;

/**
 * Where a track on a road is at one time, from events before that time only; see {@link
 * RoadMapping} for the coordinates.
 *
 * @param timeUs time on the clock of the events, microseconds
 * @param id identity of the track
 * @param xM place across the road, metres to the right
 * @param yM place along the road, metres ahead
 * @param vxMS velocity to the right, metres a second
 * @param vyMS velocity ahead, metres a second; less than 0 for what comes towards the camera
 * @param sdXM standard deviation of the place across, metres
 * @param sdYM standard deviation of the place along, metres
 * @param sdVxMS standard deviation of the velocity to the right, metres a second
 * @param sdVyMS standard deviation of the velocity ahead, metres a second
 * @param speedKmH speed, kilometres an hour
 * @param sdSpeedKmH standard deviation of the speed, kilometres an hour
 * @param lane number of the lane from the left, from 0; −1 beside the lanes
 */
public record RoadTrackPoint(
    @Column("t_us") long timeUs,
    int id,
    @Column(decimals = 3) double xM,
    @Column(decimals = 3) double yM,
    @Column(value = "vx_m_s", decimals = 3) double vxMS,
    @Column(value = "vy_m_s", decimals = 3) double vyMS,
    @Column(value = "sd_x_m", decimals = 3) double sdXM,
    @Column(value = "sd_y_m", decimals = 3) double sdYM,
    @Column(value = "sd_vx_m_s", decimals = 3) double sdVxMS,
    @Column(value = "sd_vy_m_s", decimals = 3) double sdVyMS,
    @Column(decimals = 3) double speedKmH,
    @Column(decimals = 3) double sdSpeedKmH,
    int lane) {}
