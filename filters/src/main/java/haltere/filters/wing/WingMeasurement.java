package haltere.filters.wing;

import haltere.core.sink.Column;

/**
 * An event used by a method, and its expectation.
 *
 * @param timeUs time of the event on the clock of the events, microseconds
 * @param edge its edge
 * @param measuredRad stroke angle of its pixel
 * @param expectedRad expected stroke angle, before the latency is removed
 * @param centreRad centre of the stroke at this time
 * @param amplitudeRad half of peak to peak at this time
 * @param phaseRad phase at this time, in [0, 2 pi)
 * @param frequencyHz beat frequency at this time, hertz
 */
public record WingMeasurement(
    @Column("t_us") long timeUs,
    WingPart edge,
    @Column(decimals = 6) double measuredRad,
    @Column(decimals = 6) double expectedRad,
    @Column(decimals = 6) double centreRad,
    @Column(decimals = 6) double amplitudeRad,
    @Column(decimals = 6) double phaseRad,
    @Column(decimals = 5) double frequencyHz)
    implements WingResult {}
