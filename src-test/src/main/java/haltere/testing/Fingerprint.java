package haltere.testing;

import java.lang.reflect.Array;
import java.lang.reflect.RecordComponent;
import java.util.Collection;

/**
 * Text of a value to the last bit: records component by component, arrays and collections element
 * by element, floating-point numbers exactly. Two values with the same fingerprint are bit-equal.
 */
public final class Fingerprint {
  private Fingerprint() {}

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
      for (RecordComponent component : value.getClass().getRecordComponents()) {
        text.append(component.getName()).append('=');
        append(component(fields, component), text);
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

  private static Object component(Record fields, RecordComponent component) {
    try {
      component.getAccessor().setAccessible(true);
      return component.getAccessor().invoke(fields);
    } catch (ReflectiveOperationException broken) {
      throw new IllegalStateException(fields.getClass() + "." + component.getName(), broken);
    }
  }
}
