package haltere.testing;

import java.lang.reflect.Array;
import java.lang.reflect.Method;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Iterator;
import java.util.List;

/**
 * Text of a value to the last bit: records component by component, arrays and collections element
 * by element, floating-point numbers exactly. Two values with the same fingerprint are bit-equal.
 */
public final class Fingerprint {
  private static final ClassValue<List<Method>> ACCESSORS =
      new ClassValue<>() {
        @Override
        protected List<Method> computeValue(Class<?> type) {
          List<Method> accessors = new ArrayList<>();
          for (RecordComponent component : type.getRecordComponents()) {
            component.getAccessor().setAccessible(true);
            accessors.add(component.getAccessor());
          }
          return List.copyOf(accessors);
        }
      };

  private Fingerprint() {}

  /**
   * Whether two values have the same text, found out without making it where they are equal.
   *
   * @param one as for {@link #of}
   * @param other as for {@link #of}
   * @return true if their texts are equal
   */
  public static boolean same(Object one, Object other) {
    return equal(one, other) || of(one).equals(of(other));
  }

  private static boolean equal(Object one, Object other) {
    if (one == null || other == null || one.getClass() != other.getClass()) {
      return one == other;
    }
    if (one instanceof Double number) {
      return Double.doubleToRawLongBits(number) == Double.doubleToRawLongBits((Double) other);
    }
    if (one instanceof Float number) {
      return Float.floatToRawIntBits(number) == Float.floatToRawIntBits((Float) other);
    }
    if (one instanceof Record fields) {
      for (Method accessor : ACCESSORS.get(one.getClass())) {
        if (!equal(component(fields, accessor), component((Record) other, accessor))) {
          return false;
        }
      }
      return true;
    }
    if (one instanceof Collection<?> elements) {
      Iterator<?> others = ((Collection<?>) other).iterator();
      for (Object element : elements) {
        if (!others.hasNext() || !equal(element, others.next())) {
          return false;
        }
      }
      return !others.hasNext();
    }
    if (one.getClass().isArray()) {
      int length = Array.getLength(one);
      boolean equal = length == Array.getLength(other);
      for (int i = 0; i < length && equal; i++) {
        equal = equal(Array.get(one, i), Array.get(other, i));
      }
      return equal;
    }
    return one.toString().equals(other.toString());
  }

  /**
   * The text.
   *
   * @param value null, a record, an array, a collection, a number or anything with a meaningful
   *     {@code toString}
   * @return fit for a comparison that a person can read
   */
  public static String of(Object value) {
    StringBuilder text = new StringBuilder();
    append(value, text);
    return text.toString();
  }

  private static void append(Object value, StringBuilder text) {
    if (value instanceof Double number) {
      text.append(number).append('#').append(Long.toHexString(Double.doubleToRawLongBits(number)));
    } else if (value instanceof Float number) {
      text.append(number).append('#').append(Integer.toHexString(Float.floatToRawIntBits(number)));
    } else if (value instanceof Record fields) {
      text.append(value.getClass().getSimpleName()).append('(');
      for (Method accessor : ACCESSORS.get(value.getClass())) {
        text.append(accessor.getName()).append('=');
        append(component(fields, accessor), text);
        text.append(' ');
      }
      text.append(')');
    } else if (value instanceof Collection<?> elements) {
      text.append('[');
      for (Object element : elements) {
        append(element, text);
        text.append(' ');
      }
      text.append(']');
    } else if (value != null && value.getClass().isArray()) {
      text.append('[');
      for (int i = 0; i < Array.getLength(value); i++) {
        append(Array.get(value, i), text);
        text.append(' ');
      }
      text.append(']');
    } else {
      text.append(value);
    }
  }

  private static Object component(Record fields, Method accessor) {
    try {
      return accessor.invoke(fields);
    } catch (ReflectiveOperationException broken) {
      throw new IllegalStateException(fields.getClass() + "." + accessor.getName(), broken);
    }
  }
}
