package haltere.core.format.internal.decoding;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;

/**
 * Guesses what four columns without names hold, from their first rows: the polarity has two values,
 * the time does not fall, and the column of a pixel comes before its row. If that fails, a
 * hundredth of the rows may be damaged, and times may be late by a little.
 *
 * <p>Thread rule: one thread.
 */
public final class ColumnGuess {
  /** Number of columns. */
  public static final int COLUMNS = 4;

  /** Largest fall of late times, as a share of their range; coordinates fall by most of theirs. */
  private static final double LATE = 0.1;

  /** Share of damaged rows. */
  private static final double DAMAGED = 0.01;

  private static final double MAX_PIXEL = Short.MAX_VALUE;

  private final List<double[]> rows = new ArrayList<>();

  /** A guess before the first row. */
  public ColumnGuess() {}

  /** What the numbers of a column may be. */
  private record ColumnKind(boolean isTime, boolean isPolarity, boolean isPixel, double largest) {
    /** Whether it is more likely the time than another one that may be the time, too. */
    boolean isLikelierTimeThan(ColumnKind other) {
      return isPixel == other.isPixel ? largest > other.largest : other.isPixel;
    }
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
    if (Arrays.stream(row).allMatch(Double::isFinite)) {
      rows.add(row);
    }
  }

  /**
   * The contents of the columns.
   *
   * @return in their order, or empty if they are no events
   */
  public Optional<List<EventColumn>> columns() {
    Optional<List<EventColumn>> perfect = columns(0, 0);
    return perfect.isPresent() ? perfect : columns(LATE, (int) (DAMAGED * rows.size()));
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
        : Optional.of(
            "its columns have no names; they are read as "
                + columns.stream()
                    .map(column -> column.name().toLowerCase(Locale.ROOT))
                    .collect(Collectors.joining(", ")));
  }

  /**
   * A remark for users on events without polarities.
   *
   * @param columns their contents, named or guessed
   * @return a line, or empty if there is a column of polarities
   */
  public static Optional<String> remarkOnPolarities(Collection<EventColumn> columns) {
    return columns.contains(EventColumn.POLARITY)
        ? Optional.empty()
        : Optional.of("no column of polarities is known; all events are read as ON");
  }

  /**
   * The reason why polarities cannot be read: a name of theirs without a readable column, so that
   * all events would be ON.
   *
   * @param names of all columns, readable or not
   * @param readable contents of the readable ones
   * @return a line with advice, or empty
   */
  public static Optional<String> obstacle(Stream<String> names, Collection<EventColumn> readable) {
    return !readable.contains(EventColumn.POLARITY)
            && names.anyMatch(name -> EventColumn.named(name) == EventColumn.POLARITY)
        ? Optional.of("its polarities cannot be read; save them again as a list of numbers")
        : Optional.empty();
  }

  /**
   * The reason why polarities cannot be read: several values, of which none is OFF.
   *
   * @param polarities the first ones; values that are not finite are passed over
   * @return a line with advice, or empty
   */
  public static Optional<String> obstacle(DoubleStream polarities) {
    DoubleSummaryStatistics values =
        polarities.filter(Double::isFinite).map(Math::rint).summaryStatistics();
    return values.getMin() > 0 && values.getMax() > values.getMin()
        ? Optional.of(
            "its polarities are %.0f to %.0f, none of which is known to be OFF; write them as 1 (ON) and 0 (OFF)"
                .formatted(values.getMin(), values.getMax()))
        : Optional.empty();
  }

  private Optional<List<EventColumn>> columns(double late, int damaged) {
    if (rows.isEmpty()) {
      return Optional.empty();
    }
    List<ColumnKind> kinds = new ArrayList<>();
    int time = -1;
    int polarity = -1;
    for (int i = 0; i < COLUMNS; i++) {
      int column = i;
      double[] numbers = rows.stream().mapToDouble(row -> row[column]).toArray();
      kinds.add(kind(numbers, late, damaged));
      boolean isLikelier = time < 0 || kinds.get(i).isLikelierTimeThan(kinds.get(time));
      time = kinds.get(i).isTime() && isLikelier ? i : time;
    }
    for (int i = 0; i < COLUMNS; i++) {
      polarity = kinds.get(i).isPolarity() && i != time ? i : polarity;
    }
    List<EventColumn> columns = new ArrayList<>();
    for (int i = 0; i < COLUMNS && time >= 0 && polarity >= 0; i++) {
      EventColumn rest = columns.contains(EventColumn.X) ? EventColumn.Y : EventColumn.X;
      columns.add(i == time ? EventColumn.TIME : i == polarity ? EventColumn.POLARITY : rest);
      if (i != time && i != polarity && !kinds.get(i).isPixel()) {
        return Optional.empty();
      }
    }
    return Optional.of(columns).filter(found -> !found.isEmpty());
  }

  private static ColumnKind kind(double[] numbers, double late, int damaged) {
    double[] sorted = numbers.clone();
    Arrays.sort(sorted);
    double largest = sorted[sorted.length - 1 - damaged];
    double maxFall = late * (largest - sorted[damaged]);
    double newest = Double.NEGATIVE_INFINITY;
    int falls = 0;
    int noPolarities = 0;
    int noPixels = 0;
    for (double number : numbers) {
      falls += newest - number > maxFall ? 1 : 0;
      newest = number <= largest ? Math.max(newest, number) : newest;
      noPolarities += number == 0 || number == 1 || number == -1 ? 0 : 1;
      boolean isPixel = number >= 0 && number <= MAX_PIXEL && number == Math.rint(number);
      noPixels += isPixel ? 0 : 1;
    }
    return new ColumnKind(
        falls <= damaged, noPolarities <= damaged, noPixels <= damaged, Math.abs(largest));
  }
}
