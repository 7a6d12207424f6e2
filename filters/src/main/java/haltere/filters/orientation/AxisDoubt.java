package haltere.filters.orientation;

import haltere.filters.orientation.camera.Vectors;
import java.util.Arrays;

/**
 * Decides when an axis that is followed as if it were certain is searched again: a young one, which
 * may have begun with an outlier, as soon as a line is rejected; an established one when most lines
 * are rejected several times in a row, or those of one camera longer. An established axis gives way
 * to one of two lines only if nearly the same is found twice.
 */
final class AxisDoubt {
  /** Times in a row at which most lines were rejected, after which an axis is lost. */
  private static final int LOST_AFTER = 3;

  /** Lines of one camera that were rejected in a row, after which an axis is doubted. */
  private static final int BLIND_AFTER = 5;

  /** Times at which all lines agreed, after which an axis is established. */
  private static final int ESTABLISHED = 3;

  private static final double MIN_COS_OF_SAME_AXIS = Math.cos(Math.toRadians(30));

  private final double maxCandidateAgeS;
  private final double[] candidate = new double[3];
  private double candidateAgeS = Double.POSITIVE_INFINITY;
  private int[] rejections = new int[16];
  private int rejectedTimes;
  private int agreements;

  /** No axis yet. */
  AxisDoubt(double maxCandidateAgeS) {
    this.maxCandidateAgeS = maxCandidateAgeS;
  }

  /** Begins; established at once where more than two lines were found together. */
  void reset(boolean established) {
    rejectedTimes = 0;
    agreements = established ? ESTABLISHED : 0;
    candidateAgeS = Double.POSITIVE_INFINITY;
    Arrays.fill(rejections, 0);
  }

  boolean isEstablished() {
    return agreements >= ESTABLISHED;
  }

  /** Whether most lines were used at the last time. */
  boolean isCalm() {
    return rejectedTimes == 0;
  }

  /** Time has passed. */
  void age(double dtS) {
    candidateAgeS += dtS;
  }

  /** Whether an axis that was found replaces the one that is followed. */
  boolean isWorthReplacing(AxisLaunch found) {
    boolean isConfirmed =
        candidateAgeS <= maxCandidateAgeS
            && Math.abs(Vectors.dot(found.axis(), candidate)) > MIN_COS_OF_SAME_AXIS;
    System.arraycopy(found.axis(), 0, candidate, 0, 3);
    candidateAgeS = 0;
    return isConfirmed || !isEstablished() || found.lines() > 2;
  }

  /** Counts the rejected lines of a time; returns whether to search the axis again. */
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
    boolean isMajority = count <= 2 ? taken < count : 2 * taken <= count;
    rejectedTimes = isMajority ? rejectedTimes + 1 : 0;
    if (taken == count) {
      agreements = Math.min(ESTABLISHED, count < 2 ? agreements : agreements + 1);
      return false;
    }
    return !isEstablished() || rejectedTimes >= LOST_AFTER || longest >= BLIND_AFTER;
  }
}
