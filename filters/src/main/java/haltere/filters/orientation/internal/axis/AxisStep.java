package haltere.filters.orientation.internal.axis;

import org.ejml.data.DMatrixRMaj;

/**
 * One time of a hypothesis of an axis, for a smoother.
 *
 * @param predicted the predicted state; null after a launch or an exchange of head and tail
 * @param transition of errors from the previous time; null likewise
 * @param updated the updated state
 * @param before the previous step; null after a launch
 */
public record AxisStep(
    AxisState predicted, DMatrixRMaj transition, AxisState updated, AxisStep before) {}
