package haltere.filters.track;

import haltere.core.sink.Column;

/**
 * One update of a track's Kalman filter with its intermediates. State, P and Q are in the units of
 * the track, pixels or metres on a road; innovation, S and R are in pixels. The state is (x, v_x,
 * y, v_y); Q is block-diagonal with equal blocks for both axes, R = r I.
 *
 * @param timeUs time of the update on the clock of the events, microseconds
 * @param id identity of the track
 * @param measuredX location of the cluster, first coordinate
 * @param measuredY location of the cluster, second coordinate
 * @param rPx2 variance of the measurement, px²
 * @param qXx process noise Q of the prediction before, variance of a position
 * @param qXvx process noise Q, covariance of a position and its velocity
 * @param qVxvx process noise Q, variance of a velocity
 * @param innovationX measured less predicted column, pixels
 * @param innovationY measured less predicted row, pixels
 * @param sXx innovation covariance S, variance of the column, px²
 * @param sXy innovation covariance S, covariance, px²
 * @param sYy innovation covariance S, variance of the row, px²
 * @param nis normalised innovation squared, two degrees of freedom
 * @param gainX entry of the gain K, position by the innovation of its axis
 * @param gainY entry of the gain K, position by the innovation of its axis
 * @param gainVx entry of the gain K, velocity by the innovation of its axis
 * @param gainVy entry of the gain K, velocity by the innovation of its axis
 * @param x estimated position
 * @param y estimated position
 * @param vx estimated velocity
 * @param vy estimated velocity
 * @param pXx entry of P after the update, as are pXvx to pVyvy
 */
record TrackUpdate(
    @Column("t_us") long timeUs,
    int id,
    double measuredX,
    double measuredY,
    double rPx2,
    double qXx,
    double qXvx,
    double qVxvx,
    double innovationX,
    double innovationY,
    double sXx,
    double sXy,
    double sYy,
    double nis,
    double gainX,
    double gainY,
    double gainVx,
    double gainVy,
    double x,
    double y,
    double vx,
    double vy,
    double pXx,
    double pXvx,
    double pVxvx,
    double pYy,
    double pYvy,
    double pVyvy) {}
