package haltere.filters.wing;

import haltere.core.sink.Column;

/**
 * State of a wing or of one of its edges at a time, from events before that time only.
 *
 * @param timeUs time on the clock of the events, microseconds
 * @param edge which edge, or the wing as a whole
 * @param angleRad stroke angle, 0 at the head, pi at the tail
 * @param centreRad mean stroke angle over the beat
 * @param amplitudeRad half of peak to peak
 * @param phaseRad 0 at the passage of the centre towards the tail, in [0, 2 pi)
 * @param frequencyHz beat frequency, hertz
 * @param sdAngleRad standard deviation of the angle; NaN if the method has none
 * @param sdFrequencyHz standard deviation of the frequency, hertz; NaN if the method has none
 * @param events events of the edge (of both edges, for a wing) used since the start of the estimate
 */
public record WingEstimate(
    @Column("t_us") long timeUs,
    WingPart edge,
    @Column(decimals = 6) double angleRad,
    @Column(decimals = 6) double centreRad,
    @Column(decimals = 6) double amplitudeRad,
    @Column(decimals = 6) double phaseRad,
    @Column(decimals = 5) double frequencyHz,
    @Column(decimals = 6) double sdAngleRad,
    @Column(decimals = 5) double sdFrequencyHz,
    long events)
    implements WingResult {}
