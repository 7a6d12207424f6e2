package haltere.filters.wing;

import haltere.filters.estimation.ConstMatrix;

/**
 * State of the fly at one time, to be drawn.
 *
 * @param timeUs time on the clock of the events, microseconds
 * @param phase of the tracker
 * @param geometry of the fly
 * @param regionPx radius of the region of interest about each hinge
 * @param strokesRad stroke angles of the four edges, in the order of {@link WingPart}, a row each,
 *     over the next beat, at even steps of the phase from this time on; NaN for an edge that is not
 *     tracked
 * @param frequenciesHz beat frequencies of the left and the right wing; NaN if unknown
 * @param sdRad standard deviations of the angles of the left and the right wing; NaN if unknown
 */
public record WingSnapshot(
    long timeUs,
    WingTrackerState.Phase phase,
    FlyGeometry geometry,
    double regionPx,
    ConstMatrix strokesRad,
    ConstMatrix frequenciesHz,
    ConstMatrix sdRad)
    implements WingResult {
  /**
   * Stroke angle of an edge some time after the snapshot.
   *
   * @param edge in the order of {@link WingPart}
   * @param aheadS time since the snapshot, seconds
   * @return radians, NaN for an edge that is not tracked
   */
  public double edgeRad(int edge, double aheadS) {
    int steps = strokesRad.columns();
    double turns = aheadS * frequenciesHz.get(edge / 2);
    double position = Double.isNaN(turns) ? 0 : (turns - Math.floor(turns)) * steps;
    int step = (int) position % steps;
    double from = strokesRad.get(edge, step);
    double to = strokesRad.get(edge, (step + 1) % steps);
    return from + (position - (int) position) * (to - from);
  }
}
