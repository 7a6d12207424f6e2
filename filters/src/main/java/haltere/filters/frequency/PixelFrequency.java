package haltere.filters.frequency;

import haltere.core.sink.Column;

/**
 * The frequency of a pixel at the time of a report.
 *
 * @param timeUs time of the report on the clock of the events, microseconds
 * @param frequencyHz reciprocal of the period of its events, hertz
 * @param x column of the pixel
 * @param y row of the pixel, upwards
 * @since 0.1
 */
public record PixelFrequency(
    @Column("t_us") long timeUs, @Column(decimals = 3) double frequencyHz, int x, int y) {}
