package haltere.core.format.internal.hdf5;

import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingProblem;
import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.table.RecordingTables;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Tables of an HDF5 file, read row by row: a dataset of compound elements (as PyTables and h5py
 * write them), a group with one list per column, or a single list, which is a table of one column
 * with its own name.
 *
 * <p>Thread rule: one thread. Memory is bounded by the chunks of one table.
 */
public final class Hdf5Tables implements RecordingTables {
  /** Maximum length of a text in bytes. */
  private static final int MAX_TEXT = 4096;

  private final RecordingFile file;
  private final ContainerFile container;
  private final FileContents contents;

  private Hdf5Tables(RecordingFile file) throws IOException {
    this.file = file;
    container = ContainerFile.open(file);
    contents = FileContents.of(container);
  }

  /**
   * Whether a file is HDF5, by its signature.
   *
   * @param path any file
   * @return true for HDF5
   * @throws IOException if it cannot be read
   */
  public static boolean isHdf5(Path path) throws IOException {
    try (RecordingFile file = new RecordingFile(path)) {
      return ContainerFile.signatureAt(file) >= 0;
    }
  }

  /**
   * Opens a file.
   *
   * @param path an HDF5 file
   * @return its tables
   * @throws RecordingProblem if it is not HDF5 or damaged; the message names the file
   * @throws IOException if it cannot be read
   */
  public static Hdf5Tables open(Path path) throws IOException {
    RecordingFile file = new RecordingFile(path);
    try {
      return new Hdf5Tables(file);
    } catch (IOException | RuntimeException problem) {
      file.close();
      throw problem;
    }
  }

  @Override
  public boolean has(String table) {
    return !columns(table).isEmpty();
  }

  @Override
  public Set<String> columns(String table) {
    return columnsOf(table).keySet();
  }

  private Map<String, EventTable.StoredColumn> columnsOf(String table) {
    Map<String, EventTable.StoredColumn> columns = new LinkedHashMap<>();
    for (Dataset dataset : contents.datasets()) {
      boolean isTable = dataset.name().equals(table) && dataset.isList();
      if (isTable && dataset.type().kind() == 'c') {
        for (ElementType.Member member : dataset.type().members()) {
          columns.put(
              member.name(),
              new EventTable.StoredColumn(member.name(), dataset, member.offset(), member.type()));
        }
      } else if (isTable || dataset.isList() && dataset.name().startsWith(table + "/")) {
        EventTable.StoredColumn column = EventTable.StoredColumn.of(dataset);
        columns.put(column.name(), column);
      }
    }
    return columns;
  }

  @Override
  public void read(String table, List<String> names, int required, RowListener listener)
      throws IOException {
    Map<String, EventTable.StoredColumn> there = columnsOf(table);
    if (there.isEmpty()) {
      throw contents.lacks("hold no table " + table);
    }
    for (String name : names.subList(0, required)) {
      if (!there.containsKey(name)) {
        throw problem(
            "the table "
                + table
                + " has no column "
                + name
                + "; it has "
                + String.join(", ", there.keySet()));
      }
    }
    contents.check(name -> names.stream().anyMatch(column -> name.equals(table + "/" + column)));
    there.keySet().retainAll(names);
    Dataset.check(
        container, there.values().stream().map(EventTable.StoredColumn::dataset).toList());
    try (ChunkDecompressor decompressor = new ChunkDecompressor()) {
      Cells cells = new Cells(table, names, there, decompressor);
      for (cells.row = 0; cells.row < cells.rows; cells.row++) {
        cells.load();
        listener.row(cells);
      }
    } catch (DamagedPacketException damaged) {
      throw problem("damaged: a chunk of " + table + " cannot be decompressed");
    }
  }

  private RecordingProblem problem(String words) {
    return new RecordingProblem(file.path(), words);
  }

  @Override
  public void close() throws IOException {
    file.close();
  }

  /** The current row. */
  private final class Cells implements Row {
    private final String table;
    private final List<String> names;
    private final List<EventTable.StoredColumn> columns = new ArrayList<>();
    private final List<NumberColumn> cells = new ArrayList<>();
    private final GlobalHeap heap = new GlobalHeap(container);
    private long row;
    private long rows = Long.MAX_VALUE;

    Cells(
        String table,
        List<String> names,
        Map<String, EventTable.StoredColumn> there,
        ChunkDecompressor decompressor) {
      this.table = table;
      this.names = names;
      Map<Dataset, DatasetRows> rowsOf = new HashMap<>();
      for (String name : names) {
        EventTable.StoredColumn column = there.get(name);
        columns.add(column);
        cells.add(
            column == null
                ? null
                : new NumberColumn(
                    rowsOf.computeIfAbsent(
                        column.dataset(),
                        dataset -> new DatasetRows(container, dataset, decompressor)),
                    column));
        rows = column == null ? rows : Math.min(rows, column.dataset().rows());
      }
    }

    void load() throws IOException, DamagedPacketException {
      for (NumberColumn cell : cells) {
        if (cell != null && cell.load(row) <= 0) {
          throw problem(
              "damaged: the file ends before row "
                  + row
                  + " of "
                  + rows
                  + " of "
                  + table
                  + "; it was cut off, or its writer did not close it");
        }
      }
    }

    @Override
    public long index() {
      return row;
    }

    @Override
    public double number(int column) throws IOException {
      if (columns.get(column) == null) {
        return Double.NaN;
      }
      require(columns.get(column).type().isNumber(), column, "numbers");
      return cells.get(column).real(0);
    }

    @Override
    public String text(int column) throws IOException {
      if (columns.get(column) == null) {
        return "";
      }
      ElementType type = columns.get(column).type();
      switch (type.kind()) {
        case 's':
          return bytes(column).text(Math.min(MAX_TEXT, type.bytes())).strip();
        case 'v':
          return heap.text(bytes(column), MAX_TEXT).strip();
        case 'i', 'u':
          return String.valueOf(cells.get(column).value(0, 0));
        default:
          require(type.isNumber(), column, "text");
          double value = cells.get(column).real(0);
          return value == Math.rint(value) && Math.abs(value) < 1e15
              ? String.valueOf((long) value)
              : String.valueOf(value);
      }
    }

    @Override
    public long[] list(int column) throws IOException {
      if (columns.get(column) == null) {
        return new long[0];
      }
      ElementType type = columns.get(column).type();
      boolean isList = type.kind() == 'l' && type.members().get(0).type().isNumber();
      require(isList, column, "lists of numbers");
      return heap.list(bytes(column), type.members().get(0).type());
    }

    private void require(boolean fits, int column, String what) throws RecordingProblem {
      if (!fits) {
        throw problem("the column " + names.get(column) + " of " + table + " has no " + what);
      }
    }

    private Metadata bytes(int column) {
      NumberColumn cell = cells.get(column);
      int from = cell.at();
      return new Metadata(
          container, cell.data(), from, from + columns.get(column).type().bytes(), 0);
    }
  }
}
