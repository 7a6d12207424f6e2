package haltere.filters.wing;

/**
 * Everything about the fly at one time, to be drawn.
 *
 * @param timeUs time on the clock of the events, microseconds
 * @param phase what the tracker does
 * @param geometry where the fly is
 * @param regionPx radius of the region of interest about each hinge
 * @param strokesRad stroke angles of the four edges, in the order of {@link WingPart}, over the
 *     beat that follows: for each the same number, at even steps of the phase, the first one now;
 *     NaN for an edge that is not tracked
 * @param frequenciesHz beat frequencies of the left and the right wing; NaN if unknown
 * @param sdRad standard deviations of the angles of the left and the right wing; NaN if unknown
 */
public record WingSnapshot(
    long timeUs,
    WingTrackerState.Phase phase,
    FlyGeometry geometry,
    double regionPx,
    double[] strokesRad,
    double[] frequenciesHz,
    double[] sdRad)
    implements WingResult {
  private static final int EDGES = 4;

  /** Copies the arrays. */
  public WingSnapshot {
    strokesRad = strokesRad.clone();
    frequenciesHz = frequenciesHz.clone();
    sdRad = sdRad.clone();
  }

  @Override
  public double[] strokesRad() {
    return strokesRad.clone();
  }

  @Override
  public double[] frequenciesHz() {
    return frequenciesHz.clone();
  }

  /**
   * Stroke angle of an edge some time after the snapshot.
   *
   * @param edge in the order of {@link WingPart}
   * @param aheadS time since the snapshot, seconds
   * @return radians, NaN for an edge that is not tracked
   */
  public double edgeRad(int edge, double aheadS) {
    int steps = strokesRad.length / EDGES;
    double turns = aheadS * frequenciesHz[edge / 2];
    double place = Double.isNaN(turns) ? 0 : (turns - Math.floor(turns)) * steps;
    int step = (int) place % steps;
    double from = strokesRad[edge * steps + step];
    double to = strokesRad[edge * steps + (step + 1) % steps];
    return from + (place - (int) place) * (to - from);
  }

  @Override
  public double[] sdRad() {
    return sdRad.clone();
  }
}
