package haltere.core.sink;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.lang.reflect.Method;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.Set;
import java.util.regex.Pattern;

/**
 * The components of a {@link CsvSink#isFlat flat} record: their names as columns, and their values
 * without boxes. A {@link TableFormat} reads rows with it.
 *
 * <p>Thread rule: immutable.
 *
 * @since 0.1
 */
public final class RowFields {
  /** Takes the value of a component. */
  public interface Values {
    /**
     * Takes an integer.
     *
     * @param value of any width
     */
    void number(long value);

    /**
     * Takes a floating-point number.
     *
     * @param value not-a-number means that there is no value
     * @param decimals digits behind the decimal point of a text; negative for as many as needed to
     *     read the same number back
     */
    void number(double value, int decimals);

    /**
     * Takes a floating-point number with the digits that the shorter type needs.
     *
     * @param value not-a-number means that there is no value
     * @param decimals as for double
     */
    void number(float value, int decimals);

    /**
     * Takes a truth value.
     *
     * @param value true or false
     */
    void flag(boolean value);

    /**
     * Takes a text.
     *
     * @param value not null
     */
    void text(CharSequence value);

    /** There is no value. */
    void nothing();
  }

  /** Type of the values of a component. */
  public enum FieldKind {
    /** 64-bit integers. */
    LONG,
    /** Integers of at most 32 bits. */
    INTEGER,
    /** Double precision. */
    DOUBLE,
    /** Single precision. */
    FLOAT,
    /** Truth values. */
    FLAG,
    /** Texts, characters and constants of enumerations. */
    TEXT;

    private static FieldKind of(Class<?> type) {
      if (type == double.class || type == Double.class || type == OptionalDouble.class) {
        return DOUBLE;
      }
      if (type == float.class || type == Float.class) {
        return FLOAT;
      }
      if (type == long.class || type == Long.class || type == OptionalLong.class) {
        return LONG;
      }
      if (type == boolean.class || type == Boolean.class) {
        return FLAG;
      }
      return type == char.class || !(type.isPrimitive() || isInteger(type)) ? TEXT : INTEGER;
    }

    private static boolean isInteger(Class<?> type) {
      return type == OptionalInt.class || Number.class.isAssignableFrom(type);
    }
  }

  /** Passes on one component of a row. */
  private interface FieldWriter {
    void write(Object row, Values values) throws Throwable;
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
      Pattern.compile("(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])|(?<=[a-z][XYZ])(?=[A-Z])");

  private final List<String> names;
  private final List<FieldKind> kinds = new ArrayList<>();
  private final FieldWriter[] fields;
  private final MethodHandle[] getters;

  /**
   * The components of a type.
   *
   * @param type a record
   * @throws IllegalArgumentException if it is not flat
   */
  public RowFields(Class<? extends Record> type) {
    if (!isFlat(type)) {
      throw new IllegalArgumentException(
          type.getSimpleName() + " is not a record of plain values and makes no row");
    }
    List<Leaf> leaves = leaves(type);
    names = leaves.stream().map(Leaf::name).toList();
    fields = new FieldWriter[leaves.size()];
    getters = new MethodHandle[leaves.size()];
    for (int i = 0; i < fields.length; i++) {
      Leaf leaf = leaves.get(i);
      if (leaf.decimals < -1 || leaf.decimals > 9) {
        throw new IllegalArgumentException(
            leaf.name + " cannot have " + leaf.decimals + " digits behind the decimal point");
      }
      kinds.add(FieldKind.of(leaf.get.type().returnType()));
      fields[i] = field(leaf.get, leaf.decimals);
      getters[i] = leaf.get.asType(MethodType.methodType(Object.class, Object.class));
    }
  }

  /** A column with the accessor of its value. */
  private record Leaf(String component, String name, int decimals, MethodHandle get) {}

  private static List<Leaf> leaves(Class<?> type) {
    Map<String, Leaf> leaves = new LinkedHashMap<>();
    for (RecordComponent component : type.getRecordComponents()) {
      MethodHandle get = getter(component.getAccessor());
      if (isJoined(component)) {
        for (Leaf leaf : leaves(component.getType())) {
          if (leaves.values().stream().noneMatch(there -> there.component.equals(leaf.component))) {
            MethodHandle inside = MethodHandles.filterReturnValue(get, leaf.get);
            leaves.putIfAbsent(
                leaf.name, new Leaf(leaf.component, leaf.name, leaf.decimals, inside));
          }
        }
      } else {
        Column column = component.getAnnotation(Column.class);
        Leaf leaf =
            new Leaf(
                component.getName(), name(component), column == null ? -1 : column.decimals(), get);
        leaves.remove(leaf.name);
        leaves.put(leaf.name, leaf);
      }
    }
    return List.copyOf(leaves.values());
  }

  private static boolean isJoined(RecordComponent component) {
    Column column = component.getAnnotation(Column.class);
    return column != null && column.joined() && isFlat(component.getType());
  }

  /** As {@link CsvSink#isFlat}. */
  static boolean isFlat(Class<?> type) {
    if (!type.isRecord()) {
      return false;
    }
    for (RecordComponent component : type.getRecordComponents()) {
      Class<?> plain = component.getType();
      if (!FLAT.contains(plain) && !plain.isEnum() && !isJoined(component)) {
        return false;
      }
    }
    return type.getRecordComponents().length > 0;
  }

  /** As {@link CsvSink#columns}. */
  static List<String> names(Class<? extends Record> type) {
    return leaves(type).stream().map(Leaf::name).toList();
  }

  private static String name(RecordComponent component) {
    Column column = component.getAnnotation(Column.class);
    return column != null && !column.value().isEmpty()
        ? column.value()
        : WORD_START.matcher(component.getName()).replaceAll("_").toLowerCase(Locale.ROOT);
  }

  /**
   * Names of the columns.
   *
   * @return in order
   */
  public List<String> names() {
    return names;
  }

  /**
   * Types of the columns.
   *
   * @return in order
   */
  public List<FieldKind> kinds() {
    return kinds;
  }

  /**
   * Passes on one component of a row.
   *
   * @param index of the component, from 0
   * @param row a record of the type
   * @param values receives the value
   */
  public void write(int index, Record row, Values values) {
    try {
      fields[index].write(row, values);
    } catch (Throwable thrown) {
      throw unreadable(row, thrown);
    }
  }

  /**
   * The value of one component of a row.
   *
   * @param index of the component, from 0
   * @param row a record of the type
   * @return as in the record; numbers are boxed
   */
  public Object value(int index, Record row) {
    try {
      return (Object) getters[index].invokeExact((Object) row);
    } catch (Throwable thrown) {
      throw unreadable(row, thrown);
    }
  }

  private static RuntimeException unreadable(Record row, Throwable thrown) {
    if (thrown instanceof Error error) {
      throw error;
    }
    return thrown instanceof RuntimeException own
        ? own
        : new IllegalStateException("cannot read a row of " + row.getClass(), thrown);
  }

  private static FieldWriter field(MethodHandle get, int decimals) {
    Class<?> type = get.type().returnType();
    if (type == double.class) {
      MethodHandle exact = get.asType(MethodType.methodType(double.class, Object.class));
      return (row, values) -> values.number((double) exact.invokeExact(row), decimals);
    }
    if (type == float.class) {
      MethodHandle exact = get.asType(MethodType.methodType(float.class, Object.class));
      return (row, values) -> values.number((float) exact.invokeExact(row), decimals);
    }
    if (type == long.class || type == int.class || type == short.class || type == byte.class) {
      MethodHandle exact = get.asType(MethodType.methodType(long.class, Object.class));
      return (row, values) -> values.number((long) exact.invokeExact(row));
    }
    MethodHandle exact = get.asType(MethodType.methodType(Object.class, Object.class));
    return (row, values) -> value((Object) exact.invokeExact(row), values, decimals);
  }

  private static MethodHandle getter(Method accessor) {
    accessor.setAccessible(true);
    try {
      return MethodHandles.lookup().unreflect(accessor);
    } catch (IllegalAccessException thrown) {
      throw new IllegalArgumentException("cannot read " + accessor, thrown);
    }
  }

  private static void value(Object value, Values values, int decimals) {
    if (value instanceof Double number) {
      values.number(number, decimals);
    } else if (value instanceof Float number) {
      values.number(number.floatValue(), decimals);
    } else if (value instanceof Number number) {
      values.number(number.longValue());
    } else if (value instanceof Boolean flag) {
      values.flag(flag);
    } else if (value instanceof OptionalDouble number) {
      values.number(number.orElse(Double.NaN), decimals);
    } else if (value instanceof OptionalLong number) {
      number.ifPresentOrElse(values::number, values::nothing);
    } else if (value instanceof OptionalInt number) {
      number.ifPresentOrElse(values::number, values::nothing);
    } else if (value == null) {
      values.nothing();
    } else {
      values.text(value.toString());
    }
  }
}
