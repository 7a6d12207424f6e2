package haltere.filters.cluster;

import haltere.core.sink.Column;

/**
 * Where a cluster is at one time, from events before that time only.
 *
 * @param timeUs time on the clock of the events, microseconds
 * @param id identity of the cluster, from 1, never given out twice by a tracker
 * @param xPx column of the centre, pixels
 * @param yPx row of the centre, pixels
 * @param vxPxPerS velocity to the right, pixels a second
 * @param vyPxPerS velocity upwards, pixels a second
 * @param radiusPx radius within which events belong to the cluster, pixels
 * @param events events that the cluster has taken since its birth
 */
public record ClusterTrack(
    @Column("t_us") long timeUs,
    int id,
    @Column(decimals = 3) double xPx,
    @Column(decimals = 3) double yPx,
    @Column(value = "vx_px_s", decimals = 3) double vxPxPerS,
    @Column(value = "vy_px_s", decimals = 3) double vyPxPerS,
    @Column(decimals = 3) double radiusPx,
    long events) {}
