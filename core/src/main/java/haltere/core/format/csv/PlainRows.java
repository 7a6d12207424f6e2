package haltere.core.format.csv;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.EventColumn;
import java.util.List;

/**
 * Decodes rows of digits, as nearly all are, fast: times in microseconds, or in seconds with up to
 * six decimals.
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

  /** Whether the unit of the times is one of the two. */
  private final boolean usable;

  private final boolean marked;
  private final int width;
  private final int top;

  PlainRows(CsvLayout layout, SensorGeometry geometry) {
    List<EventColumn> roles = layout.roles();
    columns = roles.size();
    timeColumn = roles.indexOf(EventColumn.TIME);
    xColumn = roles.indexOf(EventColumn.X);
    yColumn = roles.indexOf(EventColumn.Y);
    onColumn = roles.indexOf(EventColumn.POLARITY);
    seconds = layout.timeScale() == SECONDS;
    usable = seconds || layout.timeScale() == 0;
    marked = layout.marked();
    width = geometry.width();
    top = geometry.height() - 1;
  }

  /**
   * Decodes rows that are nothing but digits with one mark between them, as nearly all are; returns
   * where there is another. Eight digits are read at once, without asking how many there are.
   */
  int decode(byte[] bytes, int from, int last, EventPacket out, int maxEvents, long lastUs) {
    long[] times = out.timesUs();
    int[] addresses = out.addresses();
    int columns = this.columns;
    int size = out.size();
    long previousUs = lastUs;
    int right = width - 1;
    int topRow = top;
    int timeColumn = this.timeColumn;
    int xColumn = this.xColumn;
    int yColumn = this.yColumn;
    int onColumn = this.onColumn;
    boolean seconds = this.seconds;
    int row = from;
    rows:
    while (usable && row <= last && size < maxEvents) {
      int at = row;
      long time = 0;
      long x = 0;
      long y = 0;
      long on = 1;
      for (int i = 0; i < columns; i++) {
        long digits = Digits.digits(bytes, at);
        int count = Digits.count(digits);
        if (count == 0) {
          break rows;
        }
        long value = Digits.value(digits, count);
        at += count;
        if (count == 8) {
          digits = Digits.digits(bytes, at);
          count = Digits.count(digits);
          if (count == 8) {
            break rows;
          }
          if (count > 0) {
            value = value * Digits.power(count) + Digits.value(digits, count);
            at += count;
          }
        }
        if (i == timeColumn && seconds) {
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
        if (i == timeColumn) {
          time = value;
        } else if (i == xColumn) {
          x = value;
        } else if (i == yColumn) {
          y = value;
        } else if (i == onColumn) {
          on = value;
        }
        byte mark = bytes[at++];
        if (i < columns - 1) {
          if (marked ? mark != ',' && mark != ';' : mark != ' ' && mark != '\t') {
            break rows;
          }
        } else if (mark != '\n' && (mark != '\r' || bytes[at++] != '\n')) {
          break rows;
        }
      }
      if ((time - previousUs | right - x | topRow - y) < 0) {
        break;
      }
      previousUs = time;
      times[size] = time;
      addresses[size++] =
          (int) (topRow - y) << EventAddress.Y_SHIFT
              | (int) x << EventAddress.X_SHIFT
              | (on > 0 ? EventAddress.ON_BIT : 0);
      row = at;
    }
    out.setSize(size);
    return row;
  }
}
