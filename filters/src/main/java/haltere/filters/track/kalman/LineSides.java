package haltere.filters.track.kalman;

import java.util.Arrays;

/**
 * On which side of each counting line a track is, and which way it was counted there last. Thread
 * rule: that of its owner.
 */
final class LineSides {
  private byte[] side = new byte[0];
  private byte[] counted = new byte[0];

  void clear() {
    Arrays.fill(side, (byte) 0);
    Arrays.fill(counted, (byte) 0);
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

  /**
   * Takes note of the side on which it is: 1 beyond the line, -1 before it.
   *
   * @param way where it goes: 1 away, -1 towards the camera, 0 if that is not known
   * @return whether it is to be counted, for it has come to this side on its way and was not
   *     counted on this way before
   */
  boolean cross(int line, int newSide, int way) {
    boolean crossed = side[line] == -newSide;
    side[line] = (byte) newSide;
    if (!crossed || way == -newSide || counted[line] == newSide) {
      return false;
    }
    counted[line] = (byte) newSide;
    return true;
  }

  /**
   * Takes over where another track of the same vehicle was counted, and where it came from if it is
   * the older one.
   */
  void join(LineSides other, boolean isOlder) {
    if (side.length != other.side.length) {
      setLines(other.side.length);
    }
    for (int i = 0; i < side.length; i++) {
      counted[i] = counted[i] == 0 ? other.counted[i] : counted[i];
      side[i] = isOlder && other.side[i] != 0 ? other.side[i] : side[i];
    }
  }
}
