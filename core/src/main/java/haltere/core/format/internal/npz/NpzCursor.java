package haltere.core.format.internal.npz;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingOutline;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.decoding.EventColumn;
import haltere.core.format.internal.decoding.RowCursor;
import haltere.core.format.internal.decoding.StepBack;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Reads the columns of events side by side, a piece at a time. */
final class NpzCursor extends RowCursor {
  private static final int PIECE_ROWS = 4096;
  private static final int MAX_PIECE_BYTES = 1 << 20;

  /** The current piece of an array; the fields of its elements share it. */
  private static final class ArrayPiece {
    final ArrayBytes bytes;
    final byte[] data;
    private long from = -1;
    private int wanted;
    private int length;

    ArrayPiece(ArrayBytes bytes, int maxBytes) {
      this.bytes = bytes;
      data = new byte[maxBytes];
    }

    /** Reads bytes of the array, unless they are there; returns their number. */
    int load(long offset, int count) throws IOException {
      if (offset != from || count != wanted) {
        length = bytes.read(offset, data, count);
        from = offset;
        wanted = count;
      }
      return length;
    }
  }

  /** A column and its numbers in the current piece. */
  private static final class NpzColumn {
    final NpzLayout.ArrayColumn column;
    final NpyHeader.NpyField field;
    final int stride;
    final int offset;
    final long start;
    final ArrayPiece piece;
    final ByteBuffer values;
    final long[] numbers;

    NpzColumn(NpzLayout.ArrayColumn column, ArrayPiece piece, int pieceRows) {
      this.column = column;
      field = column.field();
      stride = column.stride();
      offset = column.offset();
      start = column.start();
      this.piece = piece;
      values = NpzLayout.order(ByteBuffer.wrap(piece.data), field);
      numbers = new long[pieceRows];
    }

    /** Whether another column is in the same elements. */
    boolean isBeside(NpzLayout.ArrayColumn other) {
      return column.array().equals(other.array()) && start == other.start();
    }

    /** Reads rows as integers; returns their number. */
    int read(long row, int rows, int scale) throws IOException {
      int count = piece.load(start + row * stride, rows * stride) / stride;
      if (field.kind() == 'f') {
        double factor = Math.pow(10, Math.abs(scale));
        for (int i = 0; i < count; i++) {
          double value = real(values, i * stride + offset, field.bytes());
          numbers[i] = rounded(scale < 0 ? value / factor : value * factor);
        }
      } else {
        for (int i = 0; i < count; i++) {
          numbers[i] = scaled(whole(values, i * stride + offset, field), scale);
        }
      }
      return count;
    }
  }

  private final NpzLayout layout;
  private final RecordingFile file;
  private final ViolationCounts violations;
  private final int width;
  private final int height;
  private final boolean fromTop;
  private final int pieceRows;
  private final NpzColumn time;
  private final NpzColumn x;
  private final NpzColumn y;
  private final NpzColumn polarity;
  private final List<NpzColumn> parts = new ArrayList<>();

  /** First row of the piece and number of rows in it. */
  private long pieceStart;

  private int pieceCount;

  NpzCursor(
      NpzLayout layout, RecordingFile file, SensorGeometry geometry, ViolationCounts violations) {
    this.layout = layout;
    this.file = file;
    this.violations = violations;
    width = geometry.width();
    height = geometry.height();
    fromTop = geometry.origin() == Origin.TOP;
    int largest =
        layout.columns().values().stream().mapToInt(NpzLayout.ArrayColumn::stride).max().orElse(1);
    pieceRows = Math.max(1, Math.min(PIECE_ROWS, MAX_PIECE_BYTES / largest));
    time = part(EventColumn.TIME);
    x = part(EventColumn.X);
    y = part(EventColumn.Y);
    polarity =
        layout.columns().containsKey(EventColumn.POLARITY) ? part(EventColumn.POLARITY) : null;
  }

  @Override
  public Optional<String> compression() {
    return Optional.of(time.piece.bytes.isDeflated() ? "deflate" : "none");
  }

  private NpzColumn part(EventColumn column) {
    NpzLayout.ArrayColumn stored = layout.columns().get(column);
    ArrayPiece piece = null;
    for (NpzColumn other : parts) {
      piece = other.isBeside(stored) ? other.piece : piece;
    }
    if (piece == null) {
      piece = new ArrayPiece(stored.array().open(file), pieceRows * stored.stride());
    }
    NpzColumn part = new NpzColumn(stored, piece, pieceRows);
    parts.add(part);
    return part;
  }

  static double real(ByteBuffer values, int at, int bytes) {
    return bytes == 8 ? values.getDouble(at) : values.getFloat(at);
  }

  static long whole(ByteBuffer values, int at, NpyHeader.NpyField field) {
    boolean signed = field.kind() == 'i';
    return switch (field.bytes()) {
      case 1 -> signed ? values.get(at) : values.get(at) & 0xff;
      case 2 -> signed ? values.getShort(at) : values.getShort(at) & 0xffff;
      case 4 -> signed ? values.getInt(at) : values.getInt(at) & 0xffffffffL;
      default -> values.getLong(at);
    };
  }

  private static long scaled(long value, int scale) {
    return switch (scale) {
      case 0 -> value;
      case 3 -> value * 1000;
      case 6 -> value * 1_000_000;
      default -> Math.floorDiv(value + 500, 1000L);
    };
  }

  @Override
  public Optional<RecordingOutline> outline() throws IOException {
    long rows = layout.rows();
    if (rows == 0) {
      return Optional.of(RecordingOutline.NOTHING);
    }
    // the end of a compressed column is reached only by decompressing all of it
    if (layout.columns().values().stream().anyMatch(column -> column.array().method() != 0)
        || time.read(0, 1, layout.timeScale()) < 1) {
      return Optional.empty();
    }
    long firstUs = time.numbers[0];
    for (NpzColumn part : parts) {
      if (part.read(rows - 1, 1, part == time ? layout.timeScale() : 0) < 1) {
        return Optional.empty();
      }
    }
    return firstUs == NO_NUMBER || time.numbers[0] == NO_NUMBER
        ? Optional.empty()
        : Optional.of(new RecordingOutline(rows, firstUs, time.numbers[0]));
  }

  @Override
  public Stop read(EventPacket out, int maxEvents) throws IOException {
    out.ensureCapacity(maxEvents);
    if (row < pieceStart || row >= pieceStart + pieceCount) {
      int wanted = (int) Math.min(pieceRows, layout.rows() - row);
      pieceStart = row;
      pieceCount = wanted <= 0 ? 0 : Math.max(0, fill(wanted));
      if (pieceCount == 0) {
        return end();
      }
    }
    int from = (int) (row - pieceStart);
    int to = (int) Math.min(pieceCount, from + (long) maxEvents - out.size());
    for (int i = from; i < to; i++) {
      long timeUs = time.numbers[i];
      long column = x.numbers[i];
      long down = y.numbers[i];
      if (timeUs == NO_NUMBER
          || column == NO_NUMBER
          || down == NO_NUMBER
          || polarity != null && polarity.numbers[i] == NO_NUMBER) {
        violations.add(Violation.UNKNOWN_WORD, offset(pieceStart + i));
        continue;
      }
      if (column < 0 || column >= width || down < 0 || down >= height) {
        violations.add(Violation.OUTSIDE_SENSOR, offset(pieceStart + i));
        continue;
      }
      if (times.goesBack(timeUs)) {
        row = pieceStart + i;
        violations.add(StepBack.kind(times), offset(row));
        violations.reached(offset(row) + 1);
        return Stop.CLOCK_WENT_BACK;
      }
      times.advance(timeUs);
      int up = (int) (fromTop ? height - 1 - down : down);
      int on = polarity == null || polarity.numbers[i] > 0 ? EventAddress.ON_BIT : 0;
      out.append(timeUs, EventAddress.pack((int) column, up, on));
    }
    row = pieceStart + to;
    violations.reached(offset(row));
    return Stop.MORE;
  }

  private int fill(int rows) throws IOException {
    int count = time.read(row, rows, layout.timeScale());
    count = Math.min(count, x.read(row, rows, 0));
    count = Math.min(count, y.read(row, rows, 0));
    return polarity == null ? count : Math.min(count, polarity.read(row, rows, 0));
  }

  private Stop end() {
    if (row < layout.rows()) {
      violations.addOnce(Violation.CUT_OFF, offset(row));
    }
    return Stop.END;
  }

  /** File offset of the time of a row; for compressed arrays, its offset in the array. */
  private long offset(long ofRow) {
    NpzLayout.Array array = layout.columns().get(EventColumn.TIME).array();
    long bytes = time.start + ofRow * time.stride;
    return array.method() == 0 ? array.offset() + bytes : bytes;
  }

  @Override
  protected long rows() {
    return Math.max(1, layout.rows());
  }

  @Override
  protected long fileBytes() {
    return file.size();
  }

  @Override
  public void close() {
    parts.forEach(part -> part.piece.bytes.close());
  }
}
