package haltere.filters.orientation.internal.axis;

import org.ejml.data.DMatrixRMaj;

/**
 * One time of a hypothesis of an axis, for a smoother.
 *
 * @param predicted the state before the time's observations; null after a launch or where head and
 *     tail were exchanged
 * @param transition of errors from the time before; null likewise
 * @param updated the state after them
 * @param before the time before; null after a launch
 */
public record AxisStep(
    AxisState predicted, DMatrixRMaj transition, AxisState updated, AxisStep before) {}
