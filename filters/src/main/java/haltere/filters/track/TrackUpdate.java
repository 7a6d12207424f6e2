package haltere.filters.track;

import haltere.core.sink.Column;

/**
 * One step of a track's filter with all that is between measurement and estimate, in the units of
 * the track: pixels, or metres on a road. Innovation, S and NIS are those of all models together,
 * weighted by the probabilities that they had before the measurement; the gain is that of the most
 * probable. Where a measurement was refused, the estimates are those predicted for its time.
 *
 * @param timeUs time of the measurement on the clock of the events, microseconds
 * @param id identity of the track
 * @param measuredX measured place, first coordinate
 * @param measuredY measured place, second coordinate
 * @param innovationX measured less expected
 * @param innovationY measured less expected
 * @param sXx variance of the innovation
 * @param sXy covariance of the innovation
 * @param sYy variance of the innovation
 * @param nis normalised innovation squared, two degrees of freedom
 * @param gainX share of the innovation that the first coordinate takes
 * @param gainY share of the innovation that the second coordinate takes
 * @param gainVx what the first velocity takes of the first innovation, 1/s
 * @param gainVy what the second velocity takes of the second innovation, 1/s
 * @param x estimated place after the update
 * @param y estimated place after the update
 * @param vx estimated velocity after the update
 * @param vy estimated velocity after the update
 * @param pXx entry of P after the update
 * @param pXvx entry of P
 * @param pVxvx entry of P
 * @param pYy entry of P
 * @param pYvy entry of P
 * @param pVyvy entry of P
 * @param accepted whether the measurement was taken in
 */
public record TrackUpdate(
    @Column("t_us") long timeUs,
    int id,
    double measuredX,
    double measuredY,
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
    double pVyvy,
    boolean accepted) {}
