package haltere.filters.orientation;

/**
 * One instant of a guess of how an axis went, for a smoother.
 *
 * @param predicted the state before the instant's observations; null after a launch or where head
 *     and tail were exchanged
 * @param transition how errors went from the instant before; null likewise
 * @param updated the state after them
 * @param before the instant before; null after a launch
 */
record AxisStep(AxisState predicted, double[] transition, AxisState updated, AxisStep before) {}
