package haltere.core.format.internal.hdf5;

import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingProblem;
import haltere.core.format.internal.decoding.EventColumn;
import java.io.IOException;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Location of the events of a file, in any layout.
 *
 * @param container the file
 * @param columns by content; at least times, columns and rows
 * @param topics of the file, that of the events first
 * @param rows events that all columns claim
 * @param inconsistent whether columns claim different numbers
 * @param timeScale power of ten of the times' unit in microseconds
 * @param timeOffsetUs offset of the times
 * @param sensor its size, if the file states it
 * @param origin origin of rows, if the file states it
 * @param triggers columns of the triggers, if there are any
 */
record EventTable(
    ContainerFile container,
    Map<EventColumn, StoredColumn> columns,
    List<String> topics,
    long rows,
    boolean inconsistent,
    int timeScale,
    long timeOffsetUs,
    Optional<SensorGeometry> sensor,
    Optional<Origin> origin,
    Optional<TriggerColumns> triggers) {
  /** Names of attributes of Haltere's files, and of others. */
  static final String WIDTH = "width";

  static final String HEIGHT = "height";
  static final String ROWS_UP = "rows_up";
  static final String TIME_OFFSET = "t_offset";

  /**
   * A column.
   *
   * @param name of its dataset, or of the field in the dataset's rows; empty in a table without
   *     names
   * @param dataset its dataset
   * @param offset in a row
   * @param type of its numbers
   */
  record StoredColumn(String name, Dataset dataset, int offset, ElementType type) {
    /** A dataset of one column. */
    static StoredColumn of(Dataset dataset) {
      String path = dataset.name();
      return new StoredColumn(
          path.substring(path.lastIndexOf('/') + 1), dataset, 0, dataset.type());
    }

    /** A field of the dataset's rows. */
    static StoredColumn of(Dataset dataset, ElementType.Member field) {
      return new StoredColumn(field.name(), dataset, field.offset(), field.type());
    }

    /** Number of the column in a table. */
    int number() {
      return dataset.stripe().number() * dataset.columnsTogether() + offset / type.bytes();
    }

    /** A column of a table without names. */
    static StoredColumn of(Dataset table, int column) {
      int inRow = column % table.columnsTogether();
      return new StoredColumn(
          "", table.ofColumn(column), inRow * table.type().bytes(), table.type());
    }
  }

  /**
   * Columns of Prophesee's triggers, in one dataset.
   *
   * @param time microseconds on the clock of the events
   * @param polarity 1 for a rising edge
   * @param channel number of the input
   */
  record TriggerColumns(StoredColumn time, StoredColumn polarity, StoredColumn channel) {
    /** Claimed number of triggers. */
    long rows() {
      return time.dataset().rows();
    }
  }

  /**
   * Finds the events of a file.
   *
   * @param topic path of the requested table, if there are several
   */
  static EventTable of(RecordingFile bytes, Optional<String> topic) throws IOException {
    ContainerFile container = ContainerFile.open(bytes);
    return new EventSearch(container).table(topic);
  }

  /** Contents of the columns of a table without names, in their order; else empty. */
  List<EventColumn> guessed() {
    return columns.entrySet().stream()
        .filter(column -> column.getValue().name().isEmpty())
        .sorted(Comparator.comparingInt(column -> column.getValue().number()))
        .map(Map.Entry::getKey)
        .toList();
  }

  /** Datasets of the columns, each once. */
  Set<Dataset> datasets() {
    Set<Dataset> datasets = new LinkedHashSet<>();
    columns.values().forEach(column -> datasets.add(column.dataset()));
    return datasets;
  }

  /** Compression of the columns: names of the methods, or "none". */
  String compression() {
    String methods =
        datasets().stream()
            .flatMap(dataset -> dataset.filters().stream())
            .flatMap(step -> step.compression().stream())
            .distinct()
            .collect(Collectors.joining(", "));
    return methods.isEmpty() ? "none" : methods;
  }

  /** Rejects columns that cannot be read, or not within bounded memory. */
  void check() throws RecordingProblem {
    Dataset.check(container, datasets());
  }

  static Map<EventColumn, StoredColumn> noColumns() {
    return new EnumMap<>(EventColumn.class);
  }
}
