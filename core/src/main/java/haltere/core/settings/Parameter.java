package haltere.core.settings;

import java.util.List;

/**
 * One setting as a person or a script sees it.
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
    List<String> choices) {
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
   * Turns a value of another form (text, another number type) into one of this type.
   *
   * @param value a string, number, boolean or enum
   * @return a value of {@link #type()} within range
   * @throws SettingsProblem if that is impossible
   */
  public Object convert(Object value) {
    Object converted = null;
    String text = String.valueOf(value).trim();
    try {
      if (type == int.class) {
        converted =
            value instanceof Double number ? exact(number, text) : (Object) Integer.valueOf(text);
      } else if (type == long.class) {
        converted =
            value instanceof Double number
                ? (Object) (long) Math.rint(wholeNumber(number, text))
                : (Object) Long.valueOf(text);
      } else if (type == double.class) {
        converted = Double.valueOf(text);
      } else if (type == boolean.class) {
        converted =
            switch (text) {
              case "true" -> Boolean.TRUE;
              case "false" -> Boolean.FALSE;
              default -> throw problem(text, "true or false");
            };
      } else if (type.isEnum()) {
        for (Object constant : type.getEnumConstants()) {
          if (((Enum<?>) constant).name().equalsIgnoreCase(text.replace('-', '_'))) {
            converted = constant;
          }
        }
        if (converted == null) {
          throw problem(text, "one of " + String.join(", ", choices));
        }
      } else {
        converted = value instanceof String ? value : text;
      }
    } catch (NumberFormatException notANumber) {
      throw problem(text, type == double.class ? "a number" : "a whole number");
    }
    check(converted);
    return converted;
  }

  private int exact(double number, String text) {
    double whole = wholeNumber(number, text);
    if (whole < Integer.MIN_VALUE || whole > Integer.MAX_VALUE) {
      throw problem(text, "a whole number");
    }
    return (int) whole;
  }

  private double wholeNumber(double number, String text) {
    if (number != Math.rint(number) || Double.isInfinite(number)) {
      throw problem(text, "a whole number");
    }
    return number;
  }

  void check(Object value) {
    if (isNumber()) {
      double number = ((Number) value).doubleValue();
      if (!(number >= min && number <= max)) {
        throw problem(String.valueOf(value), number(min) + " to " + number(max) + unitText());
      }
    } else if (value == null) {
      throw problem("null", "a value");
    }
  }

  private SettingsProblem problem(String value, String valid) {
    return new SettingsProblem("setting " + name + " is " + value + ", it must be " + valid);
  }

  private String unitText() {
    return unit.isEmpty() || unit.equals("1") ? "" : " " + unit;
  }

  private static String number(double value) {
    return value == Math.rint(value) && Math.abs(value) < 1e15
        ? Long.toString((long) value)
        : Double.toString(value);
  }
}
