package haltere.core.format.internal.hdf5;

import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingProblem;
import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.decoding.ColumnGuess;
import haltere.core.format.internal.decoding.EventColumn;
import haltere.core.format.internal.decoding.RowCursor;
import haltere.core.format.internal.decoding.SensorGuess;
import haltere.core.format.internal.decoding.Topics;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;

/**
 * Finds the events of a file: datasets in one group that are named as columns of events, or a
 * dataset whose elements have such names, or a table of four columns. The group or the dataset is a
 * topic; a file may have several, such as those of two cameras.
 */
final class EventSearch {
  private static final String METAVISION = "CD/events";
  private static final String TRIGGERS = "EXT_TRIGGER/";
  private static final int PROBE_ROWS = 4096;
  private static final int MAX_SIDE = 32768;
  private static final double FRACTION_TOLERANCE = 1e-9;

  private final ContainerFile file;
  private final FileContents contents;
  private final List<Dataset> datasets;

  EventSearch(ContainerFile file) throws IOException {
    this.file = file;
    contents = FileContents.of(file);
    datasets = new ArrayList<>(contents.datasets());
  }

  EventTable table(Optional<String> topic) throws IOException {
    datasets.sort(Comparator.comparingInt(EventSearch::rank));
    List<Candidate> candidates = candidates();
    Candidate chosen = chosen(candidates, topic);
    Map<EventColumn, EventTable.StoredColumn> columns = chosen.columns();
    List<String> topics = Topics.readFirst(chosen.path(), paths(candidates));
    long rows = Long.MAX_VALUE;
    long maxRows = 0;
    for (EventTable.StoredColumn column : columns.values()) {
      rows = Math.min(rows, column.dataset().rows());
      maxRows = Math.max(maxRows, column.dataset().rows());
    }
    boolean ours = whole(EventTable.ROWS_UP).isPresent();
    EventTable found =
        new EventTable(
            file,
            columns,
            topics,
            rows,
            rows != maxRows,
            0,
            0,
            sensor(),
            origin(chosen.path()),
            triggers());
    found.check();
    if (columns.containsKey(EventColumn.POLARITY)) {
      ColumnSample polarities = start(columns.get(EventColumn.POLARITY));
      Optional<String> obstacle = ColumnGuess.obstacle(polarities.valid());
      if (obstacle.isPresent()) {
        throw new RecordingProblem(file.bytes().path(), obstacle.get());
      }
    }
    int scale = ours ? 0 : timeScale(columns.get(EventColumn.TIME));
    return new EventTable(
        file,
        columns,
        found.topics(),
        rows,
        rows != maxRows,
        scale,
        timeOffset(scale),
        found.sensor(),
        found.origin(),
        found.triggers());
  }

  /** Origin of rows in files of Haltere and Metavision; others do not state it. */
  private Optional<Origin> origin(String topic) throws RecordingProblem {
    OptionalLong rowsUp = whole(EventTable.ROWS_UP);
    if (rowsUp.isPresent()) {
      return Optional.of(rowsUp.getAsLong() == 1 ? Origin.BOTTOM : Origin.TOP);
    }
    return topic.equals(METAVISION) ? Optional.of(Origin.TOP) : Optional.empty();
  }

  /** Rank of a dataset: well-known paths first. */
  private static int rank(Dataset dataset) {
    return dataset.name().startsWith("events/") ? 0 : dataset.name().startsWith("CD/") ? 1 : 2;
  }

  /**
   * Events of a file.
   *
   * @param path of the table, or of the group of its columns
   * @param dataset of the table, or of one of the columns
   * @param columns by content
   */
  private record Candidate(
      String path, Dataset dataset, Map<EventColumn, EventTable.StoredColumn> columns) {
    boolean isComplete() {
      return EventColumn.areEvents(columns.keySet()) && !dataset.name().startsWith(TRIGGERS);
    }
  }

  private List<Candidate> candidates() throws IOException {
    Map<String, Candidate> candidates = new LinkedHashMap<>();
    for (Dataset dataset : datasets) {
      Candidate candidate = candidate(dataset, !candidates.isEmpty());
      if (candidate.isComplete()) {
        candidates.putIfAbsent(candidate.path(), candidate);
      }
    }
    return List.copyOf(candidates.values());
  }

  private Candidate candidate(Dataset dataset, boolean isFurther) throws IOException {
    Map<EventColumn, EventTable.StoredColumn> columns = EventTable.noColumns();
    String path = dataset.name();
    if (dataset.isList() && dataset.type().kind() == 'c') {
      for (ElementType.Member member : dataset.type().members()) {
        put(columns, EventTable.StoredColumn.of(dataset, member));
      }
    } else if (dataset.isList()) {
      path = folder(dataset).isEmpty() ? "/" : folder(dataset).replaceFirst("/$", "");
      for (Dataset beside : datasets) {
        if (folder(beside).equals(folder(dataset)) && beside.isList()) {
          put(columns, EventTable.StoredColumn.of(beside));
        }
      }
    } else if (dataset.columns() == 4 && dataset.type().isNumber()) {
      try {
        columns = tableColumns(dataset);
      } catch (RecordingProblem problem) {
        if (!isFurther) {
          throw problem;
        }
      }
    }
    return new Candidate(path, dataset, columns);
  }

  private Candidate chosen(List<Candidate> candidates, Optional<String> topic)
      throws RecordingProblem {
    if (candidates.isEmpty()) {
      throw contents.lacks(
          "are no events: t, x, y and p are wanted, as lists in one group or as fields of one list");
    }
    for (Candidate candidate : candidates) {
      if (topic.isEmpty() || topic.get().replaceFirst("^/(?=.)", "").equals(candidate.path())) {
        contents.check(name -> isColumnBeside(candidate.dataset(), name));
        checkPolarities(candidate.dataset(), candidate.columns());
        return candidate;
      }
    }
    throw new RecordingProblem(file.bytes().path(), Topics.missing(topic.get(), paths(candidates)));
  }

  private static List<String> paths(List<Candidate> candidates) {
    return candidates.stream().map(Candidate::path).toList();
  }

  /** Rejects unreadable polarities, without which all events would be ON. */
  private void checkPolarities(Dataset dataset, Map<EventColumn, EventTable.StoredColumn> columns)
      throws RecordingProblem {
    Stream<String> names =
        dataset.type().kind() == 'c'
            ? dataset.type().members().stream().map(ElementType.Member::name)
            : datasets.stream()
                .map(Dataset::name)
                .filter(name -> isColumnBeside(dataset, name))
                .map(name -> name.substring(name.lastIndexOf('/') + 1));
    Optional<String> obstacle = ColumnGuess.obstacle(names, columns.keySet());
    if (obstacle.isPresent()) {
      throw new RecordingProblem(file.bytes().path(), obstacle.get());
    }
  }

  private static void put(
      Map<EventColumn, EventTable.StoredColumn> columns, EventTable.StoredColumn column) {
    EventColumn kind = EventColumn.named(column.name());
    if (kind != EventColumn.OTHER && column.type().isNumber()) {
      columns.putIfAbsent(kind, column);
    }
  }

  /** Whether a name is that of a column of events in the group of a dataset, or of its offset. */
  private static boolean isColumnBeside(Dataset dataset, String name) {
    String column = name.substring(name.lastIndexOf('/') + 1);
    return name.equals(folder(dataset) + column) && EventColumn.named(column) != EventColumn.OTHER
        || name.equals(EventTable.TIME_OFFSET);
  }

  private static String folder(Dataset dataset) {
    return dataset.name().substring(0, dataset.name().lastIndexOf('/') + 1);
  }

  private Optional<EventTable.TriggerColumns> triggers() {
    return datasets.stream()
        .filter(dataset -> dataset.name().equals(TRIGGERS + "events"))
        .filter(dataset -> dataset.isList() && dataset.rows() > 0 && dataset.filters().isEmpty())
        .map(EventSearch::triggers)
        .flatMap(Optional::stream)
        .findFirst();
  }

  private static Optional<EventTable.TriggerColumns> triggers(Dataset dataset) {
    Map<String, EventTable.StoredColumn> columns =
        dataset.type().members().stream()
            .filter(member -> member.type().isNumber())
            .map(member -> EventTable.StoredColumn.of(dataset, member))
            .collect(Collectors.toMap(EventTable.StoredColumn::name, any -> any, (a, b) -> a));
    return columns.keySet().containsAll(List.of("t", "p", "id"))
        ? Optional.of(
            new EventTable.TriggerColumns(columns.get("t"), columns.get("p"), columns.get("id")))
        : Optional.empty();
  }

  /** Columns of a table without names, by their first numbers; none if they are no events. */
  private Map<EventColumn, EventTable.StoredColumn> tableColumns(Dataset dataset)
      throws IOException {
    List<ColumnSample> starts = new ArrayList<>();
    for (int i = 0; i < ColumnGuess.COLUMNS; i++) {
      starts.add(start(EventTable.StoredColumn.of(dataset, i)));
      requireComplete(starts.get(i), "its columns");
    }
    List<double[]> numbers = starts.stream().map(ColumnSample::numbers).toList();
    List<EventColumn> guessed = ColumnGuess.of(numbers, dataset.rows());
    Map<EventColumn, EventTable.StoredColumn> columns = EventTable.noColumns();
    for (int i = 0; i < guessed.size(); i++) {
      columns.put(guessed.get(i), EventTable.StoredColumn.of(dataset, i));
    }
    return columns;
  }

  /** The first numbers of a column; cut if the file ended within them. */
  private record ColumnSample(double[] numbers, boolean isCutOff) {
    /** Those that are numbers. */
    DoubleStream valid() {
      return DoubleStream.of(numbers)
          .filter(value -> RowCursor.rounded(value) != RowCursor.NO_NUMBER);
    }

    double largest() {
      return valid().map(Math::abs).max().orElse(0);
    }

    boolean hasFractions() {
      return valid().anyMatch(value -> Math.abs(value - Math.rint(value)) > FRACTION_TOLERANCE);
    }
  }

  private ColumnSample start(EventTable.StoredColumn column) throws IOException {
    int wanted = (int) Math.min(PROBE_ROWS, column.dataset().rows());
    double[] numbers = new double[wanted];
    int row = 0;
    boolean isCutOff = false;
    try (ChunkDecompressor decompressor = new ChunkDecompressor()) {
      NumberColumn rows =
          new NumberColumn(new DatasetRows(file, column.dataset(), decompressor), column);
      while (row < wanted && !isCutOff) {
        int count = (int) Math.min(wanted - row, rows.load(row));
        isCutOff = count <= 0;
        for (int i = 0; i < count; i++) {
          numbers[row++] = rows.real(i);
        }
      }
    } catch (DamagedPacketException damaged) {
      // the rows read up to here are used
    }
    return new ColumnSample(Arrays.copyOf(numbers, row), isCutOff);
  }

  private RecordingProblem endsBefore(String what) {
    return new RecordingProblem(
        file.bytes().path(),
        file.bytes().size(),
        "the file ends before " + what + " is known; copy it again");
  }

  private void requireComplete(ColumnSample sample, String what) throws RecordingProblem {
    if (sample.isCutOff() && file.isCutOff()) {
      throw endsBefore(what);
    }
  }

  /**
   * Time unit: by eventcv's attribute, the column's name or an attribute of it; else as for other
   * files of plain numbers.
   */
  private int timeScale(EventTable.StoredColumn time) throws IOException {
    for (Attributes some : contents.attributes()) {
      OptionalDouble milliseconds = some.real("timestamp_scale_ms");
      if (milliseconds.isPresent()) {
        int power = (int) Math.round(Math.log10(milliseconds.getAsDouble())) + 3;
        if (power == 0 || power == 3 || power == 6 || power == -3) {
          return power;
        }
      }
    }
    if (EventColumn.timeScale(time.name()).isPresent()) {
      return EventColumn.timeScale(time.name()).getAsInt();
    }
    if (file.isCutOff() && contents.hasUnreadableUnit(time.dataset().name())) {
      throw endsBefore("the unit of its times");
    }
    OptionalInt stated = EventColumn.timeScale("t " + contents.timeUnit(time.dataset().name()));
    if (stated.isPresent()) {
      return stated.getAsInt();
    }
    ColumnSample sample = start(time);
    if (time.type().kind() == 'f' && !sample.hasFractions()) {
      requireComplete(sample, "the unit of its times");
    }
    return EventColumn.timeScale(sample.hasFractions(), sample.largest());
  }

  private OptionalLong whole(String name) throws RecordingProblem {
    for (Attributes some : contents.attributes()) {
      if (some.whole(name).isPresent()) {
        return some.whole(name);
      }
    }
    return OptionalLong.empty();
  }

  private Optional<SensorGeometry> sensor() throws RecordingProblem {
    long width = whole(EventTable.WIDTH).orElse(0);
    long height = whole(EventTable.HEIGHT).orElse(0);
    for (Attributes some : contents.attributes()) {
      String[] sides = some.text("geometry").split("x", -1);
      if (sides.length == 2 && sides[0].matches("\\d{1,5}") && sides[1].matches("\\d{1,5}")) {
        width = Integer.parseInt(sides[0]);
        height = Integer.parseInt(sides[1]);
      }
    }
    boolean possible = width >= 1 && width <= MAX_SIDE && height >= 1 && height <= MAX_SIDE;
    return possible ? Optional.of(SensorGuess.top((int) width, (int) height)) : Optional.empty();
  }

  private long timeOffset(int scale) throws IOException {
    for (Dataset dataset : datasets) {
      if (dataset.name().equals(EventTable.TIME_OFFSET)
          && dataset.rows() == 1
          && dataset.type().isNumber()
          && dataset.filters().isEmpty()) {
        try (ChunkDecompressor decompressor = new ChunkDecompressor()) {
          EventTable.StoredColumn column = EventTable.StoredColumn.of(dataset);
          NumberColumn number =
              new NumberColumn(new DatasetRows(file, dataset, decompressor), column);
          if (number.load(0) > 0 && number.value(0, scale) != RowCursor.NO_NUMBER) {
            return number.value(0, scale);
          }
        } catch (DamagedPacketException damaged) {
          throw new RecordingProblem(file.bytes().path(), "damaged: t_offset cannot be read");
        }
      }
    }
    return whole(EventTable.TIME_OFFSET).orElse(0);
  }
}
