package haltere.core.settings;

import java.math.BigDecimal;
import java.util.List;
import java.util.Locale;

/**
 * A setting with its name, unit, range, default and help.
 *
 * @param name dotted path in the record, such as {@code size.radiusPx}
 * @param type int, long, double, boolean, String or an enum's class
 * @param unit unit of a number, empty for anything else
 * @param min smallest valid number, negative infinity for anything else
 * @param max largest valid number, positive infinity for anything else
 * @param logarithmic whether a slider should move in equal ratios
 * @param help one sentence
 * @param defaultValue value in the record's defaults
 * @param choices names that an enum can take, else empty
 * @param label name for users, empty for its name in words
 * @since 0.1
 */
public record Parameter(
    String name,
    Class<?> type,
    String unit,
    double min,
    double max,
    boolean logarithmic,
    String help,
    Object defaultValue,
    List<String> choices,
    String label) {
  private static final BigDecimal MAX_LONG = BigDecimal.valueOf(Long.MAX_VALUE);

  /**
   * The group that the setting belongs to.
   *
   * @return all of the name before its last dot, or the empty string
   */
  public String group() {
    int dot = name.lastIndexOf('.');
    return dot < 0 ? "" : name.substring(0, dot);
  }

  /**
   * Whether the value is a number.
   *
   * @return true for int, long and double
   */
  public boolean isNumber() {
    return type == int.class || type == long.class || type == double.class;
  }

  /**
   * A value as text, which {@link #convert} reads back.
   *
   * @param value a number, without a needless fraction or exponent; a constant of an enum, in lower
   *     case with hyphens; or any other value
   * @return the text
   */
  public static String text(Object value) {
    double size = value instanceof Double number ? Math.abs(number) : Double.NaN;
    if (size == 0 || size >= 1e-6 && size <= 0x1p53) {
      return new BigDecimal(value.toString()).stripTrailingZeros().toPlainString();
    }
    return value instanceof Enum<?> constant
        ? constant.name().toLowerCase(Locale.ROOT).replace('_', '-')
        : String.valueOf(value);
  }

  /**
   * Turns a value of another form (text, another number type) into one of this type.
   *
   * @param value a string, number, boolean or enum
   * @return a value of {@link #type()} within range
   * @throws SettingsProblem if that is impossible
   */
  public Object convert(Object value) {
    Object converted = isNumber() ? number(value) : word(value);
    check(converted);
    return converted;
  }

  private Object number(Object value) {
    String text = String.valueOf(value).trim();
    try {
      if (type == double.class) {
        return Double.valueOf(text);
      }
      // BigDecimal: 25000, 25000.0 and 2.5e4 are the same whole number
      BigDecimal number = new BigDecimal(text);
      if (number.abs().compareTo(MAX_LONG) > 0) {
        throw outOfRange(text);
      }
      long whole = number.longValueExact();
      if (type == long.class) {
        return whole;
      }
      if (whole != (int) whole) {
        throw outOfRange(text);
      }
      return (int) whole;
    } catch (NumberFormatException ignored) {
      throw problem(text, type == double.class ? "a number" : "a whole number");
    } catch (ArithmeticException ignored) {
      throw problem(text, "a whole number");
    }
  }

  private Object word(Object value) {
    String text = String.valueOf(value).trim();
    if (type == boolean.class) {
      return switch (text) {
        case "true" -> Boolean.TRUE;
        case "false" -> Boolean.FALSE;
        default -> throw problem(text, "true or false");
      };
    }
    if (type.isEnum()) {
      for (Object constant : type.getEnumConstants()) {
        if (((Enum<?>) constant).name().equalsIgnoreCase(text.replace('-', '_'))) {
          return constant;
        }
      }
      throw problem(text, "one of " + String.join(", ", choices));
    }
    if (value instanceof String || value instanceof Number || value instanceof Boolean) {
      return value.toString();
    }
    throw problem(text, "a text");
  }

  void check(Object value) {
    if (isNumber()) {
      double number = ((Number) value).doubleValue();
      if (!(number >= min && number <= max) || Double.isInfinite(number)) {
        throw outOfRange(String.valueOf(value));
      }
    } else if (value == null) {
      throw problem("null", "a value");
    }
  }

  private SettingsProblem outOfRange(String value) {
    return problem(value, number(min) + " to " + number(max) + unitText());
  }

  private SettingsProblem problem(String value, String valid) {
    String given = value.isBlank() ? "empty" : value;
    return new SettingsProblem("setting " + name + " is " + given + ", it must be " + valid);
  }

  private String unitText() {
    return unit.isEmpty() || unit.equals("1") ? "" : " " + unit;
  }

  private static String number(double value) {
    return value == Math.rint(value) && Math.abs(value) < 1e15
        ? Long.toString((long) value)
        : new BigDecimal(Double.toString(value)).toPlainString();
  }
}
