package haltere.filters.track.kalman;

import haltere.filters.track.road.FoundLine;

/**
 * The row that a line has passed last, and of how many it was seen to pass them.
 *
 * <p>Thread rule: that of its owner.
 */
final class LastRow {
  private static final double SHARE_GAIN = 0.15;
  private static final double DOUBT_KEPT = 0.5;

  /** That of what has passed eight rows is less. */
  private static final double KNOWN_DOUBT = 0.005;

  private static final double FOLLOWED_SHARE = 0.45;

  private int row;
  private long timeUs;
  private double column;
  private double speedMS;

  /** Which way it goes: 1 to higher rows, -1 to lower ones. */
  private int forward;

  /** Of the last rows, the share that it was seen to pass. */
  private double share;

  /** Whether it may be no line after all: from 1, when it was found, to 0. */
  private double doubt;

  /** Begins as a vehicle that was found. */
  void begin() {
    share = 1;
  }

  /** Goes on with a line that was found. */
  void turnTo(FoundLine found, long atUs) {
    row = found.lastRow();
    doubt = 1;
    forward = found.vyMS() > 0 ? 1 : -1;
    column = found.lastColumn();
    speedMS = Math.abs(found.vyMS());
    timeUs = atUs;
  }

  /** Takes note of a row that was passed, with the column of the middle and the speed then. */
  void pass(int passedRow, long atUs, double atColumn, double alongMS) {
    int rows = Math.max(1, Math.abs(passedRow - row));
    share = share * Math.pow(1 - SHARE_GAIN, rows) + SHARE_GAIN;
    row = passedRow;
    doubt *= DOUBT_KEPT;
    timeUs = atUs;
    column = atColumn;
    speedMS = Math.abs(alongMS);
  }

  /** Whether a speed along the road is on its way. */
  boolean goes(double alongMS) {
    return alongMS * forward > 0;
  }

  /** Whether a row is still before it. */
  boolean isBefore(int otherRow) {
    return (otherRow - row) * forward > 0;
  }

  /** Whether it was seen to pass about every second row: what only seems to move passes fewer. */
  boolean isFollowed() {
    return share > FOLLOWED_SHARE;
  }

  /** Which way it goes along the road: 1 away, -1 towards the camera. */
  int forward() {
    return forward;
  }

  /**
   * Whether it may be no line after all: 1 when it was found, and less with each row that it passes
   * since.
   */
  double doubt() {
    return doubt;
  }

  /** Whether it has passed so many rows that it is a line. */
  boolean isKnown() {
    return doubt < KNOWN_DOUBT;
  }

  int row() {
    return row;
  }

  long timeUs() {
    return timeUs;
  }

  double column() {
    return column;
  }

  /** Along the road, metres a second. */
  double speedMS() {
    return speedMS;
  }
}
