package haltere.filters.wing;

/**
 * Everything about the fly at one time, to be drawn.
 *
 * @param timeUs time on the clock of the events, microseconds
 * @param phase what the tracker does
 * @param geometry where the fly is
 * @param regionPx radius of the region of interest about each hinge
 * @param edgesRad stroke angles of the four edges, in the order of {@link WingPart}; NaN for a wing
 *     that is not tracked
 * @param sdRad standard deviations of the angles of the left and the right wing; NaN if unknown
 */
public record WingSnapshot(
    long timeUs,
    WingTrackerState.Phase phase,
    FlyGeometry geometry,
    double regionPx,
    double[] edgesRad,
    double[] sdRad)
    implements WingResult {
  public WingSnapshot {
    edgesRad = edgesRad.clone();
    sdRad = sdRad.clone();
  }

  @Override
  public double[] edgesRad() {
    return edgesRad.clone();
  }

  @Override
  public double[] sdRad() {
    return sdRad.clone();
  }
}
