package haltere.core.format.internal.csv;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingClock;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.clock.AscendingTimes;
import haltere.core.format.internal.clock.EventTimes;
import haltere.core.format.internal.decoding.StepBack;
import haltere.core.format.internal.decoding.StreamDecoder;
import java.nio.ByteBuffer;

/**
 * Decodes rows of numbers. Numbers are read exactly; times are rounded to the nearest microsecond.
 * The geometry defines the origin of rows.
 *
 * <p>Thread rule: one thread.
 */
final class CsvDecoder implements StreamDecoder {
  /** Maximum length of a row. */
  private static final int MAX_ROW = 4096;

  private static final int PIECE = 16 * 1024;

  /** Bytes that may be read after the piece. */
  private static final int PADDING = 16;

  private final ViolationCounts violations;
  private final PlainRows plainRows;
  private final CsvRow exactRow;
  private final boolean decimalCommas;
  private final boolean quoted;

  private final byte[] piece = new byte[PIECE + PADDING];
  private final AscendingTimes times = new AscendingTimes();
  private boolean inLongRow;

  CsvDecoder(CsvLayout layout, SensorGeometry geometry, ViolationCounts violations) {
    this.violations = violations;
    plainRows = new PlainRows(layout, geometry);
    exactRow = new CsvRow(layout, geometry);
    decimalCommas = layout.decimalCommas();
    quoted = layout.quoted();
  }

  @Override
  public boolean decode(ByteBuffer in, long offset, EventPacket out, int maxEvents) {
    out.ensureCapacity(maxEvents);
    int start = in.position();
    int position = start;
    while (position < in.limit() && out.size() < maxEvents && !times.restarted()) {
      int length = Math.min(PIECE, in.limit() - position);
      fill(in, position, length);
      int used = decodePiece(length, offset + (position - start), out, maxEvents);
      if (used == 0 && !times.restarted()) {
        used = length >= MAX_ROW ? skipLongRow(length, offset + (position - start)) : 0;
        if (used == 0) {
          break;
        }
      }
      position += used;
    }
    in.position(position);
    return times.restarted();
  }

  private void fill(ByteBuffer in, int position, int length) {
    in.get(position, piece, 0, length);
    if (decimalCommas) {
      replace(length, ',', '.');
    }
    if (quoted) {
      replace(length, '"', ' ');
    }
  }

  private void replace(int length, char old, char with) {
    for (int i = 0; i < length; i++) {
      if (piece[i] == old) {
        piece[i] = (byte) with;
      }
    }
  }

  /** Skips a row that is too long. */
  private int skipLongRow(int length, long offset) {
    if (!inLongRow) {
      inLongRow = true;
      violations.add(Violation.UNKNOWN_WORD, offset);
    }
    return length;
  }

  /** Decodes complete rows; returns their number of bytes. */
  private int decodePiece(int length, long offset, EventPacket out, int maxEvents) {
    int last = length - 1;
    while (last >= 0 && piece[last] != '\n') {
      last--;
    }
    int row = 0;
    while (row <= last && out.size() < maxEvents) {
      if (inLongRow) {
        while (piece[row] != '\n') {
          row++;
        }
        row++;
        inLongRow = false;
        continue;
      }
      int before = out.size();
      row = plainRows.decode(piece, row, last, out, maxEvents, times.lastUs());
      if (out.size() > before) {
        times.advance(out.lastTimeUs());
      }
      if (row > last || out.size() == maxEvents) {
        break;
      }
      if (!decodeRow(row, offset + row, out)) {
        return row;
      }
      row = exactRow.end();
    }
    return row;
  }

  /** Decodes the row at an index, which ends in a line feed; false if time goes back. */
  private boolean decodeRow(int row, long offset, EventPacket out) {
    if (!exactRow.parse(piece, row)) {
      if (!exactRow.isRemark()) {
        violations.add(Violation.UNKNOWN_WORD, offset);
      }
      return true;
    }
    if (exactRow.address() < 0) {
      violations.add(Violation.OUTSIDE_SENSOR, offset);
      return true;
    }
    if (times.goesBack(exactRow.timeUs())) {
      violations.add(StepBack.kind(times), offset);
      return false;
    }
    times.advance(exactRow.timeUs());
    out.append(exactRow.timeUs(), exactRow.address());
    return true;
  }

  /** A last row without a line feed is valid if it has all columns. */
  @Override
  public boolean decodeLast(ByteBuffer in, long offset, EventPacket out, int maxEvents) {
    int length = in.remaining();
    if (length >= MAX_ROW || inLongRow) {
      return false;
    }
    fill(in, in.position(), length);
    piece[length] = '\n';
    boolean whole = exactRow.parse(piece, 0) && exactRow.address() >= 0;
    if (whole && times.goesBack(exactRow.timeUs())) {
      violations.add(StepBack.kind(times), offset);
    } else if (whole) {
      times.advance(exactRow.timeUs());
      out.append(exactRow.timeUs(), exactRow.address());
      in.position(in.limit());
    }
    return whole;
  }

  @Override
  public RecordingClock clock() {
    return RecordingClock.continuous(RecordingClock.Zero.WRITERS_CHOICE);
  }

  @Override
  public EventTimes times() {
    return times;
  }

  @Override
  public int stateLongs() {
    return 2;
  }

  @Override
  public void save(long[] state, int at) {
    times.save(state, at);
    state[at + 1] = inLongRow ? 1 : 0;
  }

  @Override
  public void restore(long[] state, int at) {
    times.restore(state, at);
    inLongRow = state[at + 1] != 0;
  }
}
