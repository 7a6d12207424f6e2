package haltere.ui.plot;

import haltere.core.sink.CsvSink;
import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * What a type of published rows holds for a plot: the time, what tells one curve from another (such
 * as a track's number or a wing's edge), and the numbers.
 *
 * <p>Thread rule: immutable, any thread.
 */
public final class RowFields {
  private static final Set<String> TIME_COLUMNS = Set.of("t_us", "time_us", "timestamp_us");
  private static final Set<String> KEY_COLUMNS = Set.of("id", "edge", "side", "lane", "camera");
  private static final Set<Class<?>> NUMBERS =
      Set.of(double.class, float.class, long.class, int.class, short.class, byte.class);

  private final MethodHandle time;
  private final Optional<MethodHandle> key;
  private final List<String> columns;
  private final List<MethodHandle> values;

  private RowFields(
      MethodHandle time,
      Optional<MethodHandle> key,
      List<String> columns,
      List<MethodHandle> values) {
    this.time = time;
    this.key = key;
    this.columns = columns;
    this.values = values;
  }

  /**
   * Looks at a type of rows; empty where it is no flat record with a time column and at least one
   * number.
   */
  public static Optional<RowFields> of(Class<?> type) {
    if (!CsvSink.isFlat(type)) {
      return Optional.empty();
    }
    List<String> names = CsvSink.columns(type.asSubclass(Record.class));
    MethodHandle time = null;
    Optional<MethodHandle> key = Optional.empty();
    List<String> columns = new ArrayList<>();
    List<MethodHandle> values = new ArrayList<>();
    RecordComponent[] components = type.getRecordComponents();
    for (int i = 0; i < components.length; i++) {
      String name = names.get(i);
      Class<?> componentType = components[i].getType();
      if (time == null && componentType == long.class && TIME_COLUMNS.contains(name)) {
        time = getter(components[i], long.class);
      } else if (key.isEmpty()
          && (KEY_COLUMNS.contains(name)
              || componentType == String.class
              || componentType.isEnum())) {
        key = Optional.of(getter(components[i], Object.class));
      } else if (NUMBERS.contains(componentType)) {
        columns.add(name);
        values.add(getter(components[i], double.class));
      }
    }
    return time == null || columns.isEmpty()
        ? Optional.empty()
        : Optional.of(new RowFields(time, key, List.copyOf(columns), List.copyOf(values)));
  }

  private static MethodHandle getter(RecordComponent component, Class<?> as) {
    try {
      component.getAccessor().setAccessible(true);
      return MethodHandles.lookup()
          .unreflect(component.getAccessor())
          .asType(MethodType.methodType(as, Object.class));
    } catch (IllegalAccessException thrown) {
      throw new IllegalArgumentException("cannot read " + component, thrown);
    }
  }

  /**
   * Names of the columns, as in a table of the rows, that are numbers and neither the time nor the
   * key.
   */
  public List<String> columns() {
    return columns;
  }

  /** The time of a row, microseconds on the recording's clock. */
  public long timeUs(Object row) {
    try {
      return (long) time.invokeExact(row);
    } catch (Throwable thrown) {
      throw unreadable(row, thrown);
    }
  }

  /** Which curve a row belongs to: the key in words, empty where all rows are of one curve. */
  public String key(Object row) {
    if (key.isEmpty()) {
      return "";
    }
    try {
      return String.valueOf((Object) key.get().invokeExact(row));
    } catch (Throwable thrown) {
      throw unreadable(row, thrown);
    }
  }

  /** The number of a row in one of the {@link #columns()}, NaN where there is none. */
  public double value(Object row, int column) {
    try {
      return (double) values.get(column).invokeExact(row);
    } catch (Throwable thrown) {
      throw unreadable(row, thrown);
    }
  }

  private static IllegalStateException unreadable(Object row, Throwable cause) {
    return new IllegalStateException("cannot read a row of " + row.getClass(), cause);
  }
}
