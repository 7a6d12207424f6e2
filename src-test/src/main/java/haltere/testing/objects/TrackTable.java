package haltere.testing.objects;

import java.io.IOException;
import java.io.Reader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.TreeMap;

/** Tables of tracks as {@code haltere track} writes them, and as other trackers may. */
public final class TrackTable {
  /** Maximum time between a moment of the truth and a row of a tracker, microseconds. */
  static final long TICK_US = 10_000;

  private TrackTable() {}

  /**
   * Reads a table.
   *
   * @param file columns t_us, id, x_px, y_px and any others of {@link TrackRow}
   * @return its rows; identities may be any words, they are numbered in order of appearance
   * @throws IOException if the file cannot be read or lacks a column
   */
  public static List<TrackRow> read(Path file) throws IOException {
    try (Reader reader = Files.newBufferedReader(file)) {
      return read(reader);
    }
  }

  /**
   * Reads a table.
   *
   * @param text as of {@link #read(Path)}
   * @return its rows
   * @throws IOException if the text cannot be read or lacks a column
   */
  public static List<TrackRow> read(Reader text) throws IOException {
    List<TrackRow> rows = new ArrayList<>();
    Map<String, Integer> ids = new HashMap<>();
    CsvTable.read(
        text,
        List.of("t_us", "id", "x_px", "y_px"),
        row ->
            rows.add(
                new TrackRow(
                    (long) row.number("t_us"),
                    ids.computeIfAbsent(row.text("id"), id -> ids.size()),
                    row.number("x_px"),
                    row.number("y_px"),
                    row.number("vx_px_s"),
                    row.number("vy_px_s"),
                    row.number("sd_x_px"),
                    row.number("sd_y_px"),
                    row.number("sd_vx_px_s"),
                    row.number("sd_vy_px_s"),
                    row.number("major_px"),
                    row.number("minor_px"),
                    row.number("angle_rad"))));
    return rows;
  }

  /** Rows by their time. */
  static NavigableMap<Long, List<TrackRow>> byTime(List<TrackRow> rows) {
    NavigableMap<Long, List<TrackRow>> ticks = new TreeMap<>();
    rows.forEach(row -> ticks.computeIfAbsent(row.timeUs(), t -> new ArrayList<>()).add(row));
    return ticks;
  }

  /**
   * Rows of the first tick at or after a time, or of the last one, if that is no more than {@value
   * #TICK_US} microseconds away.
   */
  static List<TrackRow> at(NavigableMap<Long, List<TrackRow>> ticks, long timeUs) {
    Map.Entry<Long, List<TrackRow>> tick = ticks.ceilingEntry(timeUs);
    if (tick == null) {
      tick = ticks.lastEntry();
    }
    return tick == null || Math.abs(tick.getKey() - timeUs) > TICK_US ? List.of() : tick.getValue();
  }
}
