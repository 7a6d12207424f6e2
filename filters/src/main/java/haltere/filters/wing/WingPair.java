package haltere.filters.wing;

import haltere.core.sink.Column;

/**
 * Sums and differences of both wings at a time.
 *
 * @param timeUs time on the clock of the events, microseconds
 * @param leftMinusRightRad stroke angle of the left wing minus that of the right
 * @param leftPlusRightRad sum of both stroke angles
 * @param amplitudeLeftMinusRightRad difference of the amplitudes
 * @param amplitudeLeftPlusRightRad sum of the amplitudes
 * @param phaseLagRad phase by which the left wing lags the right, in (-pi, pi]
 * @param sdLeftMinusRightRad standard deviation of the difference of the angles, and of their sum
 */
public record WingPair(
    @Column("t_us") long timeUs,
    @Column(decimals = 6) double leftMinusRightRad,
    @Column(decimals = 6) double leftPlusRightRad,
    @Column(decimals = 6) double amplitudeLeftMinusRightRad,
    @Column(decimals = 6) double amplitudeLeftPlusRightRad,
    @Column(decimals = 6) double phaseLagRad,
    @Column(decimals = 6) double sdLeftMinusRightRad)
    implements WingResult {}
