package haltere.core.format.internal.hdf5;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingOutline;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.compression.LittleEndian;
import haltere.core.format.internal.decoding.EventColumn;
import haltere.core.format.internal.decoding.RowCursor;
import haltere.core.format.internal.decoding.StepBack;
import java.io.IOException;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/** Reads the columns of events side by side. */
final class Hdf5Cursor extends RowCursor {
  private final EventTable table;
  private final ViolationCounts violations;
  private final ChunkDecompressor decompressor = new ChunkDecompressor();
  private final Map<Dataset, DatasetRows> rowsOf = new HashMap<>();
  private final int width;
  private final int height;
  private final boolean fromTop;
  private final NumberColumn time;
  private final NumberColumn x;
  private final NumberColumn y;
  private final NumberColumn polarity;
  private final boolean isCommonLayout;
  private final boolean wideTimes;

  /** Rows before this one have been read; their violations are not counted again. */
  private long counted;

  Hdf5Cursor(EventTable table, SensorGeometry geometry, ViolationCounts violations) {
    this.table = table;
    this.violations = violations;
    width = geometry.width();
    height = geometry.height();
    fromTop = geometry.origin() == Origin.TOP;
    time = column(EventColumn.TIME);
    x = column(EventColumn.X);
    y = column(EventColumn.Y);
    polarity = column(EventColumn.POLARITY);
    wideTimes = time.isWhole(8);
    isCommonLayout =
        (wideTimes || time.isWhole(4) && time.isUnsigned())
            && table.timeScale() == 0
            && x.isWhole(2)
            && y.isWhole(2)
            && polarity != null
            && (polarity.isWhole(1) || polarity.isWhole(2));
  }

  private NumberColumn column(EventColumn kind) {
    EventTable.StoredColumn column = table.columns().get(kind);
    return column == null
        ? null
        : new NumberColumn(
            rowsOf.computeIfAbsent(
                column.dataset(),
                dataset -> new DatasetRows(table.container(), dataset, decompressor)),
            column);
  }

  @Override
  public Optional<String> compression() {
    return Optional.of(table.compression());
  }

  @Override
  public Optional<RecordingOutline> outline() throws IOException {
    long rows = table.rows();
    if (rows == 0) {
      return Optional.of(RecordingOutline.NOTHING);
    }
    try {
      if (time.load(0) <= 0) {
        return Optional.empty();
      }
      long first = time.value(0, table.timeScale());
      if (time.load(rows - 1) <= 0 || x.load(rows - 1) <= 0 || y.load(rows - 1) <= 0) {
        return Optional.empty();
      }
      long last = time.value(0, table.timeScale());
      if (first == NO_NUMBER || last == NO_NUMBER) {
        return Optional.empty();
      }
      long offsetUs = table.timeOffsetUs();
      return Optional.of(new RecordingOutline(rows, first + offsetUs, last + offsetUs));
    } catch (DamagedPacketException damaged) {
      return Optional.empty();
    }
  }

  @Override
  public Stop read(EventPacket out, int maxEvents) throws IOException {
    if (row >= table.rows()) {
      return end();
    }
    out.ensureCapacity(maxEvents);
    int available;
    NumberColumn loading = time;
    try {
      long count = Math.min(maxEvents - out.size(), table.rows() - row);
      count = Math.min(count, time.load(row));
      loading = x;
      count = Math.min(count, x.load(row));
      loading = y;
      count = Math.min(count, y.load(row));
      if (polarity != null) {
        loading = polarity;
        count = Math.min(count, polarity.load(row));
      }
      available = (int) count;
    } catch (DamagedPacketException damaged) {
      count(Violation.DAMAGED_PACKET, loading.rows().offset(row));
      row = Math.min(table.rows(), loading.rows().behindChunk(row));
      counted = Math.max(counted, row);
      return Stop.MORE;
    }
    if (available <= 0) {
      return out.size() >= maxEvents && row < table.rows() ? Stop.MORE : end();
    }
    int done = isCommonLayout ? decodeCommon(out, available) : decodeAny(out, available);
    row += done;
    if (done < available) {
      count(StepBack.kind(times), time.rows().offset(row));
      counted = Math.max(counted, row + 1);
      return Stop.CLOCK_WENT_BACK;
    }
    counted = Math.max(counted, row);
    return Stop.MORE;
  }

  /** Decodes the usual types; returns the number of rows before the clock goes back. */
  private int decodeCommon(EventPacket out, int rows) {
    byte[] timeData = time.data();
    byte[] columns = x.data();
    byte[] downs = y.data();
    byte[] signs = polarity.data();
    int timeAt = time.at();
    int xAt = x.at();
    int yAt = y.at();
    int signAt = polarity.at();
    int timeStep = time.stride();
    int xStep = x.stride();
    int yStep = y.stride();
    int signStep = polarity.stride();
    int signMask = polarity.isUnsigned() ? 0xff : -1;
    long offsetUs = table.timeOffsetUs();
    long last = times.lastUs();
    int top = height - 1;
    long[] timesUs = out.timesUs();
    int[] addresses = out.addresses();
    int size = out.size();
    int i = 0;
    for (; i < rows; i++) {
      long timeUs =
          offsetUs
              + (wideTimes
                  ? (long) LittleEndian.LONG.get(timeData, timeAt)
                  : (int) LittleEndian.INT.get(timeData, timeAt) & 0xffffffffL);
      int column = (short) LittleEndian.SHORT.get(columns, xAt) & 0xffff;
      int down = (short) LittleEndian.SHORT.get(downs, yAt) & 0xffff;
      int on = (signs[signAt] & signMask) > 0 ? EventAddress.ON_BIT : 0;
      timeAt += timeStep;
      xAt += xStep;
      yAt += yStep;
      signAt += signStep;
      if (column >= width || down >= height) {
        leftOut(i, Violation.OUTSIDE_SENSOR);
        continue;
      }
      if (timeUs < last) {
        times.advance(last);
        times.goesBack(timeUs);
        break;
      }
      last = timeUs;
      timesUs[size] = timeUs;
      addresses[size++] = EventAddress.pack(column, fromTop ? top - down : down, on);
    }
    times.advance(last);
    out.setSize(size);
    return i;
  }

  private int decodeAny(EventPacket out, int rows) {
    for (int i = 0; i < rows; i++) {
      long stored = time.value(i, table.timeScale());
      long timeUs = stored + table.timeOffsetUs();
      long column = x.value(i, 0);
      long down = y.value(i, 0);
      long sign = polarity == null ? 1 : polarity.value(i, 0);
      if (stored == NO_NUMBER || column == NO_NUMBER || down == NO_NUMBER || sign == NO_NUMBER) {
        leftOut(i, Violation.UNKNOWN_WORD);
        continue;
      }
      if (column < 0 || column >= width || down < 0 || down >= height) {
        leftOut(i, Violation.OUTSIDE_SENSOR);
        continue;
      }
      if (times.goesBack(timeUs)) {
        return i;
      }
      times.advance(timeUs);
      int up = (int) (fromTop ? height - 1 - down : down);
      int on = sign > 0 ? EventAddress.ON_BIT : 0;
      out.append(timeUs, EventAddress.pack((int) column, up, on));
    }
    return rows;
  }

  private void leftOut(int fromRow, Violation kind) {
    if (row + fromRow >= counted) {
      violations.add(kind, time.rows().offset(row + fromRow));
    }
  }

  private void count(Violation kind, long offset) {
    if (row >= counted) {
      violations.add(kind, offset);
    }
  }

  private Stop end() {
    if (row < table.rows()) {
      violations.addOnce(Violation.CUT_OFF, table.container().bytes().size());
    }
    return Stop.END;
  }

  @Override
  protected long rows() {
    return table.rows();
  }

  @Override
  protected long fileBytes() {
    return table.container().bytes().size();
  }

  @Override
  public void close() {
    decompressor.close();
  }
}
