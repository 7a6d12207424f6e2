package haltere.filters.wing;

import haltere.core.sink.Column;

/**
 * An event that a method has taken in, and what was expected of it.
 *
 * @param timeUs time of the event on the clock of the events, microseconds
 * @param edge which edge it belongs to
 * @param measuredRad stroke angle of the event's pixel
 * @param expectedRad what was expected of it, before latency is taken out
 * @param centreRad centre of the stroke as known then
 * @param amplitudeRad half of peak to peak as known then
 * @param phaseRad phase as known then, in [0, 2 pi)
 * @param frequencyHz beat frequency as known then, hertz
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
