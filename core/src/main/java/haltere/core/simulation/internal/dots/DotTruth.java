package haltere.core.simulation.internal.dots;

/**
 * The truth about one dot at one time.
 *
 * @param tUs time on the clock of the events, microseconds
 * @param id number of the dot, from 0
 * @param xPx centre, pixels to the right
 * @param yPx centre, pixels up
 * @param vxPxS velocity to the right, pixels a second
 * @param vyPxS velocity upwards, pixels a second
 * @param radiusPx radius, pixels
 */
public record DotTruth(
    long tUs, int id, double xPx, double yPx, double vxPxS, double vyPxS, double radiusPx) {}
