package haltere.filters.wing.tracker;

import haltere.filters.estimation.Angles;
import haltere.filters.wing.RunningAverageSettings;
import haltere.filters.wing.WingPositionSettings;
import haltere.filters.wing.WingTrackerSettings;

/**
 * Updates the body after each beat of both wings as in Cardinale (2006): it moves to the middle
 * between the mean positions of both wings' events, with the heading across the line between them.
 */
final class BodyFollower {
  private static final int BOTH = 3;

  private final FlyPosition position;
  private WingTrackerSettings settings;
  private boolean follows;
  private final double[] sumX = new double[2];
  private final double[] sumY = new double[2];
  private final double[] meanX = new double[2];
  private final double[] meanY = new double[2];
  private final int[] count = new int[2];

  /** Wings whose beat has ended since the last move, as bits. */
  private int ended;

  BodyFollower(FlyPosition position, WingTrackerSettings settings) {
    this.position = position;
    apply(settings);
  }

  void apply(WingTrackerSettings changed) {
    settings = changed;
    follows = changed.average().bodyUpdate() || changed.average().headingUpdate();
  }

  void launch() {
    ended = 0;
    for (int side = 0; side < 2; side++) {
      clear(side);
    }
  }

  private void clear(int side) {
    sumX[side] = 0;
    sumY[side] = 0;
    count[side] = 0;
  }

  /** Processes an event after the running average; returns whether the body was moved. */
  boolean event(int side, int x, int y) {
    if (!follows) {
      return false;
    }
    sumX[side] += x;
    sumY[side] += y;
    count[side]++;
    return ended == BOTH && follow();
  }

  /** Ends a beat of a wing. */
  void beat(int side) {
    if (count[side] > 0) {
      meanX[side] = sumX[side] / count[side];
      meanY[side] = sumY[side] / count[side];
      ended |= 1 << side;
    }
    clear(side);
  }

  private boolean follow() {
    RunningAverageSettings average = settings.average();
    WingPositionSettings offsets = settings.position();
    ended = 0;
    double share = average.mixingFactor();
    double acrossX = meanX[0] - meanX[1];
    double acrossY = meanY[0] - meanY[1];
    if (average.bodyUpdate()) {
      double middleX = (meanX[0] + meanX[1]) / 2 + offsets.bodyOffsetXPx();
      double middleY = (meanY[0] + meanY[1]) / 2 + offsets.bodyOffsetYPx();
      position.shift(share * (middleX - position.axisX), share * (middleY - position.axisY));
      if (TrackerParts.isOriginal(settings)) {
        double distancePx = Math.hypot(acrossX, acrossY);
        position.resize(position.sizePx + share * (distancePx - position.sizePx), offsets);
      }
    }
    if (average.headingUpdate()) {
      double heading = Math.atan2(acrossY, acrossX) - Math.PI / 2 + offsets.headingOffsetRad();
      position.turn(share * Angles.wrapPi(heading - position.frames[0].headingRad()));
    }
    position.settle();
    return true;
  }
}
