package haltere.core.sink;

import haltere.core.format.AtomicFile;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.lang.reflect.Method;
import java.lang.reflect.RecordComponent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.Set;
import java.util.function.Consumer;
import java.util.regex.Pattern;

/**
 * Writes records as rows of a table: comma separated, UTF-8, a header line, lines that end in a
 * line feed, a point as decimal point whatever the locale. Names of components become names of
 * columns in snake_case unless {@link Column} says otherwise. Not-a-number, null and an empty
 * optional are empty fields; infinity is {@code inf}; enum constants are as their {@code toString}.
 *
 * <p>Thread rule: one thread at a time.
 *
 * @param <R> type of the rows, a {@link #isFlat flat} record
 */
public final class CsvSink<R extends Record> implements Consumer<R>, Closeable {
  /** Writes one field of a row. */
  private interface Field {
    void write(Object row, CsvText text) throws Throwable;
  }

  private static final Set<Class<?>> FLAT =
      Set.of(
          byte.class,
          Byte.class,
          short.class,
          Short.class,
          int.class,
          Integer.class,
          long.class,
          Long.class,
          float.class,
          Float.class,
          double.class,
          Double.class,
          boolean.class,
          Boolean.class,
          char.class,
          Character.class,
          String.class,
          OptionalInt.class,
          OptionalLong.class,
          OptionalDouble.class);
  private static final Pattern WORD_START =
      Pattern.compile("(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])");

  private final AtomicFile file;
  private final CsvText text;
  private final Field[] fields;
  private long rows;

  private CsvSink(AtomicFile file, OutputStream out, Class<R> type) {
    if (!isFlat(type)) {
      throw new IllegalArgumentException(
          type.getSimpleName() + " is not a record of plain values and makes no row");
    }
    this.file = file;
    text = new CsvText(out);
    fields = fields(type);
    List<String> names = columns(type);
    for (int i = 0; i < names.size(); i++) {
      if (i > 0) {
        text.raw(',');
      }
      text.text(names.get(i));
    }
    text.raw('\n');
  }

  /**
   * Starts a table beside its place, where it appears when it is {@link #finish() finished}.
   *
   * @param <R> type of the rows
   * @param file where it will be
   * @param type class of the rows
   * @param overwrite whether a file that is there may be replaced
   * @return an open table
   * @throws IOException if the file is there and may not be replaced, or cannot be written
   * @throws IllegalArgumentException if the type is not flat
   */
  public static <R extends Record> CsvSink<R> create(Path file, Class<R> type, boolean overwrite)
      throws IOException {
    AtomicFile atomic = AtomicFile.create(file, overwrite);
    try {
      return new CsvSink<>(atomic, atomic.stream(), type);
    } catch (RuntimeException thrown) {
      atomic.close();
      throw thrown;
    }
  }

  /**
   * Starts a table on a stream, such as standard output.
   *
   * @param <R> type of the rows
   * @param out flushed by {@link #finish()}, never closed
   * @param type class of the rows
   * @return an open table
   * @throws IllegalArgumentException if the type is not flat
   */
  public static <R extends Record> CsvSink<R> on(OutputStream out, Class<R> type) {
    return new CsvSink<>(null, Objects.requireNonNull(out, "out"), type);
  }

  /**
   * Whether records of a type are rows: each component a number, a truth value, a character, a
   * text, an enum constant or an optional number.
   *
   * @param type any class
   * @return true if a table can be made of them
   */
  public static boolean isFlat(Class<?> type) {
    if (!type.isRecord()) {
      return false;
    }
    for (RecordComponent component : type.getRecordComponents()) {
      if (!FLAT.contains(component.getType()) && !component.getType().isEnum()) {
        return false;
      }
    }
    return type.getRecordComponents().length > 0;
  }

  /**
   * Names of the columns.
   *
   * @param type a record
   * @return in order
   */
  public static List<String> columns(Class<? extends Record> type) {
    List<String> names = new ArrayList<>();
    for (RecordComponent component : type.getRecordComponents()) {
      Column column = component.getAnnotation(Column.class);
      names.add(
          column != null && !column.value().isEmpty()
              ? column.value()
              : WORD_START.matcher(component.getName()).replaceAll("_").toLowerCase(Locale.ROOT));
    }
    return names;
  }

  private static Field[] fields(Class<?> type) {
    RecordComponent[] components = type.getRecordComponents();
    Field[] fields = new Field[components.length];
    for (int i = 0; i < fields.length; i++) {
      Column column = components[i].getAnnotation(Column.class);
      int decimals = column == null ? -1 : column.decimals();
      if (decimals < -1 || decimals > 9) {
        throw new IllegalArgumentException(
            components[i] + " cannot have " + decimals + " digits behind the decimal point");
      }
      fields[i] = field(components[i], decimals);
    }
    return fields;
  }

  private static Field field(RecordComponent component, int decimals) {
    MethodHandle get = getter(component.getAccessor());
    Class<?> type = component.getType();
    if (type == double.class) {
      MethodHandle exact = get.asType(MethodType.methodType(double.class, Object.class));
      return (row, text) -> text.number((double) exact.invokeExact(row), decimals);
    }
    if (type == float.class) {
      MethodHandle exact = get.asType(MethodType.methodType(float.class, Object.class));
      return (row, text) -> text.number((float) exact.invokeExact(row), decimals);
    }
    if (type == long.class || type == int.class || type == short.class || type == byte.class) {
      MethodHandle exact = get.asType(MethodType.methodType(long.class, Object.class));
      return (row, text) -> text.number((long) exact.invokeExact(row));
    }
    MethodHandle exact = get.asType(MethodType.methodType(Object.class, Object.class));
    return (row, text) -> value((Object) exact.invokeExact(row), text, decimals);
  }

  private static MethodHandle getter(Method accessor) {
    accessor.setAccessible(true);
    try {
      return MethodHandles.lookup().unreflect(accessor);
    } catch (IllegalAccessException thrown) {
      throw new IllegalArgumentException("cannot read " + accessor, thrown);
    }
  }

  private static void value(Object value, CsvText text, int decimals) {
    if (value instanceof Double number) {
      text.number(number, decimals);
    } else if (value instanceof Float number) {
      text.number(number.floatValue(), decimals);
    } else if (value instanceof Number number) {
      text.number(number.longValue());
    } else if (value instanceof Enum<?> constant) {
      text.text(constant.toString());
    } else if (value instanceof OptionalDouble number) {
      text.number(number.orElse(Double.NaN), decimals);
    } else if (value instanceof OptionalLong number) {
      number.ifPresent(text::number);
    } else if (value instanceof OptionalInt number) {
      number.ifPresent(text::number);
    } else if (value != null) {
      text.text(value.toString());
    }
  }

  /**
   * Writes a row.
   *
   * @param row the row
   * @throws UncheckedIOException if it cannot be written
   */
  @Override
  public void accept(R row) {
    Objects.requireNonNull(row, "row");
    try {
      for (int i = 0; i < fields.length; i++) {
        if (i > 0) {
          text.raw(',');
        }
        fields[i].write(row, text);
      }
      text.endLine();
      rows++;
    } catch (IOException thrown) {
      throw new UncheckedIOException(thrown);
    } catch (RuntimeException | Error thrown) {
      throw thrown;
    } catch (Throwable thrown) {
      throw new IllegalStateException("cannot read a row of " + row.getClass(), thrown);
    }
  }

  /**
   * Rows written.
   *
   * @return a count, without the header
   */
  public long rows() {
    return rows;
  }

  /**
   * Completes the file and puts it in its place.
   *
   * @throws IOException if that fails; the target is then as it was
   */
  public void finish() throws IOException {
    text.flush();
    if (file != null) {
      file.commit();
    }
  }

  /**
   * Releases the file; one that was not finished leaves nothing.
   *
   * @throws IOException if it cannot be removed
   */
  @Override
  public void close() throws IOException {
    if (file != null) {
      file.close();
    }
  }
}
