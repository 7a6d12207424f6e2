package haltere.filters.wing;

import haltere.core.sink.Column;

/**
 * Kalman filter minus running average, where both run.
 *
 * @param timeUs time on the clock of the events, microseconds
 * @param edge which wing
 * @param angleRad difference of the stroke angles
 * @param centreRad difference of the centres
 * @param amplitudeRad difference of the amplitudes
 * @param phaseRad difference of the phases, in (-pi, pi]
 * @param frequencyHz difference of the frequencies, hertz
 */
public record WingDifference(
    @Column("t_us") long timeUs,
    WingPart edge,
    @Column(decimals = 6) double angleRad,
    @Column(decimals = 6) double centreRad,
    @Column(decimals = 6) double amplitudeRad,
    @Column(decimals = 6) double phaseRad,
    @Column(decimals = 5) double frequencyHz)
    implements WingResult {}
