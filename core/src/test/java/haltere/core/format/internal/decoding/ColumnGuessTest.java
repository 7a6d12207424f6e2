package haltere.core.format.internal.decoding;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Columns without names are told by their numbers. */
class ColumnGuessTest {
  private static final int ROWS = 1000;

  private final SplittableRandom random = new SplittableRandom(1);

  /** Rows of events whose times are late by up to a number of microseconds. */
  private double[][] events(String order, int lateUs) {
    double[][] rows = new double[ROWS][ColumnGuess.COLUMNS];
    for (int i = 0; i < ROWS; i++) {
      for (int k = 0; k < ColumnGuess.COLUMNS; k++) {
        rows[i][k] =
            switch (order.charAt(k)) {
              case 't' -> 1_000_000 + 10 * i - random.nextInt(lateUs + 1);
              case 'x' -> random.nextInt(346);
              case 'y' -> random.nextInt(260);
              default -> random.nextInt(2);
            };
      }
    }
    return rows;
  }

  private static Optional<List<EventColumn>> guess(double[][] rows) {
    ColumnGuess guess = new ColumnGuess();
    for (double[] row : rows) {
      guess.add(row);
    }
    return guess.columns();
  }

  private static Optional<List<EventColumn>> columns(String order) {
    return Optional.of(
        order
            .chars()
            .mapToObj(
                c ->
                    switch (c) {
                      case 't' -> EventColumn.TIME;
                      case 'x' -> EventColumn.X;
                      case 'y' -> EventColumn.Y;
                      default -> EventColumn.POLARITY;
                    })
            .toList());
  }

  @ParameterizedTest
  @CsvSource({"txyp, 0", "xytp, 0", "xypt, 0", "ptxy, 0", "txyp, 50", "xypt, 900"})
  void columnsAreToldInAnyOrderAlsoOfLateEvents(String order, int lateUs) {
    assertEquals(columns(order), guess(events(order, lateUs)));
  }

  @Test
  void fewDamagedRowsDoNotHideTheOthers() {
    double[][] rows = events("xytp", 20);
    for (int i = 0; i < 9; i++) {
      rows[random.nextInt(ROWS)][random.nextInt(ColumnGuess.COLUMNS)] =
          random.nextBoolean() ? 1e15 : -70_000;
    }
    rows[5][2] = Double.NaN;
    assertEquals(columns("xytp"), guess(rows));
  }

  @Test
  void otherNumbersAreNoEvents() {
    assertEquals(Optional.empty(), guess(new double[0][]));
    double[][] noPolarity = events("txyt", 0);
    assertEquals(Optional.empty(), guess(noPolarity));
    double[][] noTime = events("xyxp", 0);
    assertEquals(Optional.empty(), guess(noTime));
    double[][] damaged = events("txyp", 0);
    for (int i = 0; i < ROWS; i += 20) {
      damaged[i][1] = -1;
    }
    assertEquals(Optional.empty(), guess(damaged));
  }
}
