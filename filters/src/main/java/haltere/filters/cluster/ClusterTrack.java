package haltere.filters.cluster;

import haltere.core.sink.Column;
import haltere.filters.trail.Ellipse;
import haltere.filters.trail.TrailPoint;

/**
 * State of a cluster at one time, from events before that time only.
 *
 * @param timeUs time on the clock of the events, microseconds
 * @param id identity of the cluster, from 1, never reused by a tracker
 * @param xPx column of the centre, pixels
 * @param yPx row of the centre, pixels
 * @param vxPxS velocity to the right, pixels a second
 * @param vyPxS velocity upwards, pixels a second
 * @param radiusPx geometric mean of the half axes, pixels
 * @param aspect half axis at the angle over the other one
 * @param angleRad direction of the first half axis, counterclockwise from +x, above -pi/2 and up to
 *     pi/2
 * @param events events of the cluster since its birth
 * @param mass events, each decayed with the time constant of the mass
 * @param rateHz events a second
 * @param ageUs time since its birth, microseconds; it was born before it was visible
 */
public record ClusterTrack(
    @Column("t_us") long timeUs,
    int id,
    @Column(decimals = 3) double xPx,
    @Column(decimals = 3) double yPx,
    @Column(value = "vx_px_s", decimals = 3) double vxPxS,
    @Column(value = "vy_px_s", decimals = 3) double vyPxS,
    @Column(decimals = 3) double radiusPx,
    @Column(decimals = 3) double aspect,
    @Column(decimals = 4) double angleRad,
    long events,
    @Column(decimals = 1) double mass,
    @Column(decimals = 1) double rateHz,
    long ageUs)
    implements TrailPoint {
  /** {@return the half axes; the first one, at the angle, may be the shorter one} */
  public Ellipse ellipse() {
    double root = Math.sqrt(aspect);
    return new Ellipse(radiusPx * root, radiusPx / root, angleRad);
  }
}
