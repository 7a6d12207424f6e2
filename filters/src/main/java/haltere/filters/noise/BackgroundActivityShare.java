package haltere.filters.noise;

import haltere.core.sink.Column;

/**
 * Result of {@link BackgroundActivity} in a window of 0.1 s of event time.
 *
 * @param timeUs end of the window on the clock of the events, microseconds
 * @param correlationUs correlation time of an event with its neighbours, microseconds
 * @param events number of input events
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
