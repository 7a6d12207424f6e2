package haltere.core.sink;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.Random;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CsvSinkTest {
  enum Side {
    LEFT,
    RIGHT
  }

  record Row(
      @Column("t_us") long timeUs,
      int eventCount,
      double meanX1Px,
      float leftNIS,
      boolean isVisible,
      String name,
      Side side,
      OptionalDouble angleRad,
      OptionalLong id,
      Double maybe,
      @Column(decimals = 2) double rounded) {}

  record Numbers(double value) {}

  record Floats(float value) {}

  record Fixed(@Column(decimals = 3) double value) {}

  record Nested(Row row) {}

  record Empty() {}

  private static final Row PLAIN =
      new Row(
          -5,
          3,
          0.25,
          1.5f,
          true,
          "a",
          Side.LEFT,
          OptionalDouble.of(2),
          OptionalLong.of(7),
          1.0,
          1.005);

  @SafeVarargs
  private static <R extends Record> String text(Class<R> type, R... rows) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    CsvSink<R> sink = CsvSink.on(bytes, type);
    for (R row : rows) {
      sink.accept(row);
    }
    assertEquals(rows.length, sink.rows());
    try {
      sink.finish();
    } catch (IOException e) {
      throw new AssertionError(e);
    }
    return bytes.toString(StandardCharsets.UTF_8);
  }

  @Test
  void componentsBecomeColumns() {
    assertEquals(
        "t_us,event_count,mean_x1_px,left_nis,is_visible,name,side,angle_rad,id,maybe,rounded\n"
            + "-5,3,0.25,1.5,true,a,LEFT,2,7,1,1.00\n",
        text(Row.class, PLAIN));
  }

  @Test
  void absentValuesAreEmptyFields() {
    Row row =
        new Row(
            0,
            0,
            Double.NaN,
            Float.NaN,
            false,
            null,
            null,
            OptionalDouble.empty(),
            OptionalLong.empty(),
            null,
            Double.NaN);
    assertEquals("0,0,,,false,,,,,,", text(Row.class, row).lines().skip(1).findFirst().get());
  }

  @Test
  void localeDoesNotChangeNumbers() {
    Locale before = Locale.getDefault();
    try {
      Locale.setDefault(Locale.GERMANY);
      assertEquals("value\n1234567.5\n", text(Numbers.class, new Numbers(1234567.5)));
      Locale.setDefault(new Locale("tr"));
      assertEquals(List.of("t_us", "event_count"), CsvSink.columns(Row.class).subList(0, 2));
    } finally {
      Locale.setDefault(before);
    }
  }

  @Test
  void textIsQuotedIfNecessary() {
    record Text(String value) {}
    for (String[] pair :
        new String[][] {
          {"plain", "plain"},
          {"a,b", "\"a,b\""},
          {"say \"no\"", "\"say \"\"no\"\"\""},
          {"two\nlines", "\"two\nlines\""},
          {"cr\r", "\"cr\r\""},
          {" space", "\" space\""},
          {"Flügel µs", "Flügel µs"},
          {"", ""}
        }) {
      assertEquals("value\n" + pair[1] + "\n", text(Text.class, new Text(pair[0])));
    }
  }

  @Test
  void commentsBetweenRowsDoNotCountAsRows() throws IOException {
    record Row(int value) {}
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    CsvSink<Row> sink = CsvSink.on(out, Row.class);
    sink.accept(new Row(1));
    sink.comment("from here on, µs\nand more");
    sink.accept(new Row(2));
    sink.finish();
    assertEquals(
        "value\n1\n# from here on, µs and more\n2\n", out.toString(StandardCharsets.UTF_8));
    assertEquals(2, sink.rows());
  }

  @Test
  void numbersAreReadBackExactly() {
    Random random = new Random(3);
    for (int i = 0; i < 20_000; i++) {
      double value =
          switch (i % 4) {
            case 0 -> Double.longBitsToDouble(random.nextLong());
            case 1 -> random.nextInt(2_000_000) / 1e3 - 1000;
            case 2 -> (random.nextDouble() - 0.5) * Math.pow(10, random.nextInt(20) - 8);
            default -> random.nextLong() / 1e6;
          };
      if (Double.isFinite(value)) {
        assertEquals(value, Double.parseDouble(written(text -> text.number(value, -1))));
      }
      float small = Float.intBitsToFloat(random.nextInt());
      if (Float.isFinite(small)) {
        assertEquals(small, Float.parseFloat(written(text -> text.number(small, -1))), 0f);
      }
    }
    for (String number : List.of("0.1", "12.345", "-0.000001", "100", "0", "1234567.891")) {
      assertEquals(
          "value\n" + number + "\n", text(Numbers.class, new Numbers(Double.parseDouble(number))));
    }
    assertEquals("value\n0.1\n65536\n", text(Floats.class, new Floats(0.1f), new Floats(65536)));
  }

  private static String written(Consumer<CsvText> write) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    CsvText target = new CsvText(bytes);
    write.accept(target);
    try {
      target.flush();
    } catch (IOException e) {
      throw new AssertionError(e);
    }
    return bytes.toString(StandardCharsets.UTF_8);
  }

  @Test
  void fixedDecimalsRoundToTheNearest() {
    Random random = new Random(4);
    for (int i = 0; i < 5_000; i++) {
      double value = (random.nextDouble() - 0.5) * Math.pow(10, random.nextInt(18));
      double read = Double.parseDouble(text(Fixed.class, new Fixed(value)).substring(6));
      assertEquals(value, read, 0.0005 + 2 * Math.ulp(value));
    }
    assertEquals(
        "value\n0.000\n-0.001\ninf\n-inf\n\n",
        text(
            Fixed.class,
            new Fixed(-0.0004),
            new Fixed(-0.0006),
            new Fixed(Double.POSITIVE_INFINITY),
            new Fixed(Double.NEGATIVE_INFINITY),
            new Fixed(Double.NaN)));
  }

  @Test
  void longsOfEveryLengthAreWritten() {
    record Longs(long value) {}
    assertEquals(
        "value\n-9223372036854775808\n9223372036854775807\n-1\n1000\n",
        text(
            Longs.class,
            new Longs(Long.MIN_VALUE),
            new Longs(Long.MAX_VALUE),
            new Longs(-1),
            new Longs(1000)));
  }

  @Test
  void onlyFlatRecordsAreRows() {
    assertTrue(CsvSink.isFlat(Row.class));
    assertFalse(CsvSink.isFlat(Nested.class));
    assertFalse(CsvSink.isFlat(Empty.class));
    assertFalse(CsvSink.isFlat(String.class));
    assertThrows(
        IllegalArgumentException.class,
        () -> CsvSink.on(new ByteArrayOutputStream(), Nested.class));
  }

  @Test
  void tableAppearsCompleteOrNotAtAllAndReplacesNoFile(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("rows.csv");
    try (CsvSink<Numbers> sink = CsvSink.create(file, Numbers.class, false)) {
      for (int i = 0; i < 20_000; i++) {
        sink.accept(new Numbers(i));
      }
      assertFalse(Files.exists(file));
    }
    assertEquals(0, Files.list(folder).count());
    try (CsvSink<Numbers> sink = CsvSink.create(file, Numbers.class, false)) {
      for (int i = 0; i < 20_000; i++) {
        sink.accept(new Numbers(i));
      }
      sink.finish();
    }
    assertEquals(20_001, Files.readAllLines(file).size());
    assertThrows(IOException.class, () -> CsvSink.create(file, Numbers.class, false));
    assertThrows(IllegalArgumentException.class, () -> CsvSink.create(file, Nested.class, true));
    assertEquals(List.of(file), Files.list(folder).toList());
  }

  @Test
  void joinedColumnsReplaceTheirComponentExceptPlainOnes() {
    record Point(int x, int y, int age) {}
    record Seen(@Column("y") int row, @Column(joined = true) Point point, int lane, int age) {}
    assertEquals(List.of("y", "x", "lane", "age"), CsvSink.columns(Seen.class));
  }
}
