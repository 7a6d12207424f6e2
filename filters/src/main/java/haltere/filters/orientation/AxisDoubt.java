package haltere.filters.orientation;

import java.util.Arrays;

/**
 * When an axis that is followed as if it were certain had better be looked for anew: a young one,
 * which may have begun with a line that was none, as soon as a line is rejected; an established one
 * when most lines are rejected several times in a row, or those of one camera longer.
 */
final class AxisDoubt {
  /** Instants in a row at which most lines were rejected, after which an axis is lost. */
  private static final int LOST_AFTER = 3;

  /** Lines of one camera that were rejected in a row, after which an axis is doubted. */
  private static final int BLIND_AFTER = 5;

  /** Instants at which all lines agreed, after which an axis is established. */
  private static final int ESTABLISHED = 3;

  private int[] rejections = new int[16];
  private int rejectedInstants;
  private int agreements;

  /** Begins; established at once where that is no chance. */
  void reset(boolean established) {
    rejectedInstants = 0;
    agreements = established ? ESTABLISHED : 0;
    Arrays.fill(rejections, 0);
  }

  boolean isEstablished() {
    return agreements >= ESTABLISHED;
  }

  /** Whether most lines were used at the last instant. */
  boolean isCalm() {
    return rejectedInstants == 0;
  }

  /** Takes note of an instant; returns whether to look for the axis anew. */
  boolean note(LineMeasurement[] lines, int count) {
    int taken = 0;
    int longest = 0;
    for (int i = 0; i < count; i++) {
      int camera = lines[i].camera;
      if (camera >= rejections.length) {
        rejections = Arrays.copyOf(rejections, camera + 1);
      }
      rejections[camera] = lines[i].used ? 0 : rejections[camera] + 1;
      taken += lines[i].used ? 1 : 0;
      longest = Math.max(longest, rejections[camera]);
    }
    if (count == 0) {
      return false;
    }
    boolean most = count <= 2 ? taken < count : 2 * taken <= count;
    rejectedInstants = most ? rejectedInstants + 1 : 0;
    if (taken == count) {
      agreements = Math.min(ESTABLISHED, count < 2 ? agreements : agreements + 1);
      return false;
    }
    return agreements < ESTABLISHED || rejectedInstants >= LOST_AFTER || longest >= BLIND_AFTER;
  }
}
