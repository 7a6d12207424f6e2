package haltere.ui.wing;

/**
 * Format of a log of wings.
 *
 * @param rows when there is a row
 * @param layout how a row is written
 */
public record WingLogFormat(Rows rows, Layout layout) {
  /** Condition of a row. */
  public enum Rows {
    /** For each event used by a method. */
    EVENT,
    /** At each tick of the rate of the settings, for each edge and each wing. */
    TICK,
    /** At the end of each beat of each wing. */
    BEAT
  }

  /** How a row is written. */
  public enum Layout {
    /** A table with commas and a line of column names. */
    TABLE,
    /** Tabs, and edges by number, as the wing tracker of 2006 wrote it. */
    ORIGINAL
  }

  /** Checks that both go together: the original knows no rows of beats. */
  public WingLogFormat {
    if (layout == Layout.ORIGINAL && rows == Rows.BEAT) {
      throw new IllegalArgumentException(
          "the original's layout has rows of events or ticks, not of beats");
    }
  }

  @Override
  public String toString() {
    return rows.name().toLowerCase(java.util.Locale.ROOT)
        + (layout == Layout.ORIGINAL ? ", original" : "");
  }
}
