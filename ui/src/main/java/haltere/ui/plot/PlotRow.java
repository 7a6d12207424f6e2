package haltere.ui.plot;

import haltere.core.sink.CsvSink;
import haltere.core.sink.RowFields;
import haltere.core.sink.RowFields.FieldKind;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * Plot properties of a type of published rows: time, key of the curve (such as a track's number or
 * a wing's edge), and numbers.
 *
 * <p>Thread rule: immutable, any thread.
 */
public final class PlotRow {
  private static final Set<String> TIME_COLUMNS = Set.of("t_us", "time_us", "timestamp_us");
  private static final Set<String> KEY_COLUMNS = Set.of("id", "edge", "side", "lane", "camera");

  private final RowFields fields;
  private final List<String> columns = new ArrayList<>();

  /** Index of the time in a row, -1 without one. */
  private int time = -1;

  private int key = -1;

  private PlotRow(RowFields fields) {
    this.fields = fields;
    for (int i = 0; i < fields.names().size(); i++) {
      String name = fields.names().get(i);
      FieldKind kind = fields.kinds().get(i);
      if (time < 0 && kind == FieldKind.LONG && TIME_COLUMNS.contains(name)) {
        time = i;
      } else if (key < 0 && (KEY_COLUMNS.contains(name) || kind == FieldKind.TEXT)) {
        key = i;
      } else if (kind != FieldKind.TEXT && kind != FieldKind.FLAG) {
        columns.add(name);
      }
    }
  }

  /**
   * Examines a type of rows; empty unless it is a flat record with a time column and at least one
   * number.
   */
  public static Optional<PlotRow> of(Class<?> type) {
    return Optional.of(type)
        .filter(CsvSink::isFlat)
        .map(flat -> new PlotRow(new RowFields(flat.asSubclass(Record.class))))
        .filter(row -> row.time >= 0 && !row.columns.isEmpty());
  }

  /** Names of the columns that are numbers and neither the time nor the key. */
  public List<String> columns() {
    return List.copyOf(columns);
  }

  /** Index of one of the {@link #columns()} in a row, -1 for unknown names. */
  public int index(String column) {
    return columns.contains(column) ? fields.names().indexOf(column) : -1;
  }

  /** The time of a row, microseconds on the recording's clock. */
  public long timeUs(Record row) {
    return (long) fields.value(time, row);
  }

  /** Key of a row's curve; empty if all rows belong to one curve. */
  public String key(Record row) {
    return key < 0 ? "" : String.valueOf(fields.value(key, row));
  }

  /** The number of a row at an {@link #index}, NaN without one. */
  public double value(Record row, int index) {
    return fields.value(index, row) instanceof Number number ? number.doubleValue() : Double.NaN;
  }
}
