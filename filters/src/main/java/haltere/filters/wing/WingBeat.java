package haltere.filters.wing;

import haltere.core.sink.Column;

/**
 * One beat of a wing, from one passage through the centre towards the tail to the next.
 *
 * @param side which wing
 * @param beat number of the beat of this wing since tracking began, from 1
 * @param timeUs time of the end of the beat, microseconds
 * @param periodUs length of the beat, microseconds
 * @param frequencyHz beat frequency, hertz
 * @param amplitudeRad half of peak to peak
 * @param minRad smallest stroke angle
 * @param maxRad largest stroke angle
 * @param phaseLagRad phase by which this wing lags the other, in (-pi, pi]; NaN if the other is not
 *     tracked
 */
public record WingBeat(
    WingPart side,
    long beat,
    @Column("t_us") long timeUs,
    @Column(decimals = 2) double periodUs,
    @Column(decimals = 5) double frequencyHz,
    @Column(decimals = 6) double amplitudeRad,
    @Column(decimals = 6) double minRad,
    @Column(decimals = 6) double maxRad,
    @Column(decimals = 6) double phaseLagRad)
    implements WingResult {}
