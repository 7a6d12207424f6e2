package haltere.filters.track.road;

/** Lines that no search has found. */
public final class GivenLine {
  private GivenLine() {}

  /** A line of which only the speed matters. */
  public static FoundLine ofSpeed(double vyMS) {
    FoundLine line = new FoundLine();
    line.vyMS = vyMS;
    return line;
  }

  /** Lets a line be one that five rows tell of. */
  public static void set(
      FoundLine line, double xM, double yM, double vyMS, double halfM, int lastRow) {
    line.xM = xM;
    line.yM = yM;
    line.vyMS = vyMS;
    line.rows = 5;
    line.varianceY = 0.01;
    line.varianceVy = 0.01;
    line.halfWidthM = halfM;
    line.seenHalfM = halfM;
    line.lastRow = lastRow;
  }
}
