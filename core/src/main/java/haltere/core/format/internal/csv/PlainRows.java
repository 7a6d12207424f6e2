package haltere.core.format.internal.csv;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.internal.decoding.EventColumn;
import java.util.List;

/**
 * Fast decoder for rows of plain digits, the usual case: times in microseconds, or in seconds with
 * up to six decimals.
 *
 * <p>Thread rule: one thread.
 */
final class PlainRows {
  private static final long MAX_SECONDS = 1_000_000_000_000L;
  private static final int SECONDS = 6;

  private final int columns;
  private final int timeColumn;
  private final int xColumn;
  private final int yColumn;
  private final int onColumn;
  private final boolean seconds;

  /** Values of a row's columns. */
  private final long[] values;

  /** Whether the unit of the times is supported. */
  private final boolean usable;

  private final boolean marked;
  private final int width;
  private final int top;
  private final boolean fromTop;

  PlainRows(CsvLayout layout, SensorGeometry geometry) {
    List<EventColumn> roles = layout.roles();
    columns = roles.size();
    timeColumn = roles.indexOf(EventColumn.TIME);
    xColumn = roles.indexOf(EventColumn.X);
    yColumn = roles.indexOf(EventColumn.Y);
    // without this column, the index after the others is used, whose value is ON
    onColumn = roles.contains(EventColumn.POLARITY) ? roles.indexOf(EventColumn.POLARITY) : columns;
    values = new long[columns + 1];
    values[columns] = 1;
    seconds = layout.timeScale() == SECONDS;
    usable = seconds || layout.timeScale() == 0;
    marked = layout.marked();
    width = geometry.width();
    top = geometry.height() - 1;
    fromTop = geometry.origin() == Origin.TOP;
  }

  /**
   * Decodes rows of digits and single separators; returns the index of the first other row. Eight
   * digits are read at once.
   */
  int decode(byte[] bytes, int from, int last, EventPacket out, int maxEvents, long lastUs) {
    long[] times = out.timesUs();
    int[] addresses = out.addresses();
    int columns = this.columns;
    int size = out.size();
    long previousUs = lastUs;
    int right = width - 1;
    int topRow = top;
    boolean fromTop = this.fromTop;
    int timeColumn = this.timeColumn;
    int xColumn = this.xColumn;
    int yColumn = this.yColumn;
    int onColumn = this.onColumn;
    int lastOnColumn = onColumn == columns - 1 ? onColumn : columns;
    boolean seconds = this.seconds;
    long[] values = this.values;
    int row = from;
    rows:
    while (usable && row <= last && size < maxEvents) {
      int at = row;
      for (int i = 0; i < columns; i++) {
        if (i == lastOnColumn && bytes[at + 1] == '\n' && (bytes[at] & ~1) == '0') {
          values[i] = bytes[at] & 1;
          at += 2;
          break;
        }
        long digits = Digits.digits(bytes, at);
        int count = Digits.count(digits);
        if (count == 0) {
          break rows;
        }
        long value = Digits.value(digits, count);
        if (count == 8) {
          digits = Digits.digits(bytes, at + 8);
          count = Digits.count(digits);
          if (count == 8) {
            break rows;
          }
          if (count > 0) {
            value = value * Digits.power(count) + Digits.value(digits, count);
          }
          at += 8;
        }
        at = behind(at, count);
        if (seconds && i == timeColumn) {
          if (bytes[at] != '.') {
            break rows;
          }
          digits = Digits.digits(bytes, at + 1);
          count = Digits.count(digits);
          if (count == 0 || count > 6 || value > MAX_SECONDS) {
            break rows;
          }
          value = value * 1_000_000 + Digits.value(digits, count) * Digits.power(6 - count);
          at += 1 + count;
        }
        values[i] = value;
        byte mark = bytes[at++];
        if (i < columns - 1) {
          if (marked ? mark != ',' && mark != ';' : mark != ' ' && mark != '\t') {
            break rows;
          }
        } else if (mark != '\n' && (mark != '\r' || bytes[at++] != '\n')) {
          break rows;
        }
      }
      long time = values[timeColumn];
      long x = values[xColumn];
      long y = values[yColumn];
      if ((time - previousUs | right - x | topRow - y) < 0) {
        break;
      }
      previousUs = time;
      times[size] = time;
      addresses[size++] =
          (int) (fromTop ? topRow - y : y) << EventAddress.Y_SHIFT
              | (int) x << EventAddress.X_SHIFT
              | (values[onColumn] > 0 ? EventAddress.ON_BIT : 0);
      row = at;
    }
    out.setSize(size);
    return row;
  }

  /**
   * End of a number. With branches, the processor predicts the case and reads ahead, while an
   * addition would wait for the count.
   */
  private static int behind(int at, int count) {
    return switch (count) {
      case 1 -> at + 1;
      case 2 -> at + 2;
      case 3 -> at + 3;
      default -> at + count;
    };
  }
}
