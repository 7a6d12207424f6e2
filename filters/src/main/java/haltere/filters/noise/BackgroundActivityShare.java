package haltere.filters.noise;

import haltere.core.sink.Column;

/**
 * What {@link BackgroundActivity} did in a window of a tenth of a second of event time.
 *
 * @param timeUs end of the window on the clock of the events, microseconds
 * @param correlationUs how long an event supported its neighbours, microseconds
 * @param events how many came in
 * @param passedShare share of them that passed, 0 to 1
 * @param removedShare share of them that were removed, 0 to 1
 * @since 0.1
 */
public record BackgroundActivityShare(
    @Column("t_us") long timeUs,
    int correlationUs,
    long events,
    @Column(decimals = 4) double passedShare,
    @Column(decimals = 4) double removedShare) {}
