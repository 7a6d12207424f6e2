package haltere.filters.orientation;

/**
 * One instant of an axis filter, for a smoother.
 *
 * @param timeUs microseconds
 * @param predicted the state before the instant's observations; null after a launch
 * @param transition how errors went from the instant before; null after a launch
 * @param updated the state after them
 */
record AxisStep(long timeUs, AxisState predicted, double[] transition, AxisState updated) {}
