package haltere.filters.track.kalman;

import java.util.Arrays;

/**
 * On which side of each counting line a track is, and which way it was counted there last. Thread
 * rule: that of its owner.
 */
final class LineSides {
  /** Times the side: it was not counted. */
  private static final int REFUSED = 2;

  private byte[] side = new byte[0];
  private byte[] counted = new byte[0];
  private double lastM = Double.NaN;
  private boolean isElsewhere;

  void clear() {
    Arrays.fill(side, (byte) 0);
    Arrays.fill(counted, (byte) 0);
    lastM = Double.NaN;
    isElsewhere = false;
  }

  /**
   * Takes note of where it is along the road. What is suddenly farther back on its way was not
   * where it seemed to be: it was on something higher than the road if it drives away, and
   * otherwise on another vehicle, which was counted and not this one.
   */
  void follow(double alongM, int way, double mostM) {
    if ((alongM - lastM) * way < -mostM) {
      Arrays.fill(side, (byte) 0);
      isElsewhere = true;
      if (way < 0) {
        Arrays.fill(counted, (byte) 0);
      }
    }
    lastM = alongM;
  }

  /** Makes room for so many lines. */
  void setLines(int lines) {
    if (side.length != lines) {
      side = new byte[lines];
      counted = new byte[lines];
    }
  }

  /** Whether it was never clear of a line. */
  boolean isNew(int line) {
    return side[line] == 0;
  }

  /** Whether it was on a side before. */
  boolean isAt(int line, int sameSide) {
    return side[line] == sameSide;
  }

  /** Whether it was never known anywhere else than on its way. */
  boolean isOnItsWay() {
    return !isElsewhere;
  }

  /**
   * Takes note of the side on which it is: 1 beyond the line, -1 before it.
   *
   * @param way where it goes: 1 away, -1 towards the camera, 0 if that is not known
   * @param hasCome whether it has come from the other side before it was known
   * @return whether it is to be counted, for it has come to this side on its way and was not
   *     counted on this way before
   */
  boolean cross(int line, int newSide, int way, boolean hasCome) {
    boolean crossed = side[line] == -newSide || hasCome;
    side[line] = (byte) newSide;
    return crossed && way != -newSide && counted[line] * newSide <= 0;
  }

  /** Takes note that it was counted when it went to a side. */
  void count(int line, int newSide) {
    counted[line] = (byte) newSide;
  }

  /** Takes note that it was not counted when it went to a side, for its vehicle had been. */
  void refuse(int line, int newSide) {
    counted[line] = (byte) (REFUSED * newSide);
  }

  /** Whether it and another were both counted where both went the same way: there are two. */
  boolean isOtherThan(LineSides other) {
    for (int i = 0; i < Math.min(side.length, other.side.length); i++) {
      if (counted[i] == other.counted[i] && Math.abs(counted[i]) == 1) {
        return true;
      }
    }
    return false;
  }

  /**
   * Takes over where another track of the same vehicle was counted, and that it was before a line
   * if it is the older one: what was beyond it may have been higher than the road.
   *
   * @param way where the vehicle goes: 1 away, -1 towards the camera
   */
  void join(LineSides other, boolean isOlder, int way) {
    if (side.length == 0) {
      setLines(other.side.length);
    }
    for (int i = 0; i < Math.min(side.length, other.side.length); i++) {
      counted[i] = counted[i] == 0 ? other.counted[i] : counted[i];
      side[i] = isOlder && other.side[i] == -way ? other.side[i] : side[i];
    }
  }
}
