package haltere.core.format.internal.decoding;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * Guesses what four columns without names hold, from their first rows: the polarity has two values,
 * the time does not fall, or only by a little if events are late, and the column of a pixel comes
 * before its row.
 *
 * <p>Thread rule: one thread.
 */
public final class ColumnGuess {
  /** Number of columns. */
  public static final int COLUMNS = 4;

  /** Largest fall of late times, as a share of their range; coordinates fall by most of theirs. */
  private static final double LATE = 0.1;

  private static final double MAX_PIXEL = Short.MAX_VALUE;

  private final boolean[] isPolarity = new boolean[COLUMNS];
  private final boolean[] isPixel = new boolean[COLUMNS];
  private final double[] smallest = new double[COLUMNS];
  private final double[] largest = new double[COLUMNS];
  private final double[] fall = new double[COLUMNS];
  private int rows;

  /** A guess before the first row. */
  public ColumnGuess() {
    Arrays.fill(isPolarity, true);
    Arrays.fill(isPixel, true);
    Arrays.fill(smallest, Double.POSITIVE_INFINITY);
    Arrays.fill(largest, Double.NEGATIVE_INFINITY);
  }

  /**
   * Guesses from the first numbers of four columns.
   *
   * @param columns may have different lengths
   * @param allRows number of rows of the table; one without rows has the usual columns
   * @return the contents in their order; none if they are no events
   */
  public static List<EventColumn> of(List<double[]> columns, long allRows) {
    if (allRows == 0) {
      return List.of(EventColumn.TIME, EventColumn.X, EventColumn.Y, EventColumn.POLARITY);
    }
    ColumnGuess guess = new ColumnGuess();
    int rows = columns.stream().mapToInt(column -> column.length).min().orElse(0);
    for (int i = 0; i < rows; i++) {
      int row = i;
      guess.add(columns.stream().mapToDouble(column -> column[row]).toArray());
    }
    return guess.columns().orElse(List.of());
  }

  /**
   * Adds a row.
   *
   * @param row four numbers; if one of them is not a number, the row is passed over
   */
  public void add(double... row) {
    if (!Arrays.stream(row).allMatch(Double::isFinite)) {
      return;
    }
    rows++;
    for (int i = 0; i < COLUMNS; i++) {
      double value = row[i];
      isPolarity[i] &= value == 0 || value == 1 || value == -1;
      isPixel[i] &= value >= 0 && value <= MAX_PIXEL && value == Math.rint(value);
      fall[i] = rows == 1 ? 0 : Math.max(fall[i], largest[i] - value);
      smallest[i] = Math.min(smallest[i], value);
      largest[i] = Math.max(largest[i], value);
    }
  }

  /**
   * The contents of the columns.
   *
   * @return in their order, or empty if they are no events
   */
  public Optional<List<EventColumn>> columns() {
    Optional<List<EventColumn>> inOrder = columns(0);
    return inOrder.isPresent() ? inOrder : columns(LATE);
  }

  /**
   * A remark for users on columns that were guessed.
   *
   * @param columns their contents
   * @return a line, or empty without columns
   */
  public static Optional<String> remark(List<EventColumn> columns) {
    return columns.isEmpty()
        ? Optional.empty()
        : Optional.of("its columns have no names; they are read as " + columns);
  }

  private Optional<List<EventColumn>> columns(double late) {
    int time = -1;
    for (int i = 0; i < COLUMNS; i++) {
      boolean isLikelier =
          time < 0
              || isPixel[time] && !isPixel[i]
              || isPixel[time] == isPixel[i] && largest[i] > largest[time];
      if (fall[i] <= late * (largest[i] - smallest[i]) && isLikelier) {
        time = i;
      }
    }
    int sign = -1;
    for (int i = 0; i < COLUMNS; i++) {
      sign = isPolarity[i] && i != time ? i : sign;
    }
    if (rows == 0 || time < 0 || sign < 0) {
      return Optional.empty();
    }
    List<EventColumn> columns = new ArrayList<>();
    for (int i = 0; i < COLUMNS; i++) {
      EventColumn rest = columns.contains(EventColumn.X) ? EventColumn.Y : EventColumn.X;
      columns.add(i == time ? EventColumn.TIME : i == sign ? EventColumn.POLARITY : rest);
      if (i != time && i != sign && !isPixel[i]) {
        return Optional.empty();
      }
    }
    return Optional.of(columns);
  }
}
