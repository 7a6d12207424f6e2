package haltere.core.simulation.internal.road;

import haltere.core.sink.Column;

/**
 * The truth about one vehicle of {@link RoadScene} at one time. There is a row for every vehicle
 * whose box touches the sensor, hidden or not.
 *
 * <p>On the road, the position of a vehicle is the middle of its footprint: x to the right of the
 * camera, y ahead of it, so that a vehicle that drives away has a positive speed along y. In the
 * picture, its centre is the middle of the upright box around its whole outline, as if nothing hid
 * it and the sensor had no border. A vehicle is not flat: the spot of the road that is seen at the
 * pixel of that centre lies behind it and moves at another speed. That spot, which is what a map
 * from pixels to the road makes of a tracker's perfect answer, is given as well.
 *
 * @param tUs time on the clock of the events, microseconds
 * @param id number of the vehicle, never used for another one
 * @param kind its kind
 * @param lane the lane that its middle is in, counted from the left, from 0
 * @param xM middle of the footprint, metres to the right
 * @param yM middle of the footprint, metres ahead
 * @param vxMS velocity to the right, metres a second
 * @param vyMS velocity ahead, metres a second
 * @param xPx centre of the box, pixels to the right
 * @param yPx centre of the box, pixels up
 * @param vxPxS velocity of that centre to the right, pixels a second
 * @param vyPxS velocity of that centre upwards, pixels a second
 * @param widthPx width of the box, pixels
 * @param heightPx height of the box, pixels
 * @param visibleShare share of the outline's area that is on the sensor and not hidden
 * @param spotXM spot of the road at the centre's pixel, metres to the right; not a number above the
 *     horizon, as the three that follow
 * @param spotYM that spot, metres ahead
 * @param spotVxMS velocity of that spot to the right, metres a second
 * @param spotVyMS velocity of that spot ahead, metres a second
 */
public record RoadTruth(
    long tUs,
    int id,
    VehicleKind kind,
    int lane,
    double xM,
    double yM,
    @Column("vx_m_s") double vxMS,
    @Column("vy_m_s") double vyMS,
    double xPx,
    double yPx,
    double vxPxS,
    double vyPxS,
    double widthPx,
    double heightPx,
    double visibleShare,
    @Column("spot_x_m") double spotXM,
    @Column("spot_y_m") double spotYM,
    @Column("spot_vx_m_s") double spotVxMS,
    @Column("spot_vy_m_s") double spotVyMS) {}
