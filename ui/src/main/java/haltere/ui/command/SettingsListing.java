package haltere.ui.command;

import haltere.core.settings.Parameter;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.Consumer;

/** Lists things that can be set: a name, a sentence, and a line for each setting. */
final class SettingsListing {
  private final Consumer<String> lines;
  private boolean begun;

  /**
   * A listing that is empty yet.
   *
   * @param lines receives it
   */
  SettingsListing(Consumer<String> lines) {
    this.lines = lines;
  }

  /**
   * Adds one thing, an empty line behind the one before.
   *
   * @param name what it is called
   * @param description a sentence
   * @param parameters its settings
   */
  void add(String name, String description, List<Parameter> parameters) {
    if (begun) {
      lines.accept("");
    }
    begun = true;
    lines.accept(name);
    lines.accept("  " + description);
    int nameWidth = 0;
    int rangeWidth = 0;
    for (Parameter parameter : parameters) {
      nameWidth = Math.max(nameWidth, parameter.name().length());
      rangeWidth = Math.max(rangeWidth, values(parameter).length());
    }
    for (Parameter parameter : parameters) {
      lines.accept(
          String.format(
              Locale.ROOT,
              "    %-" + nameWidth + "s  %-" + rangeWidth + "s  %s",
              parameter.name(),
              values(parameter),
              parameter.help()));
    }
  }

  /** Adds the presets of the thing that was added last, if there are any. */
  void presets(Set<String> names) {
    if (!names.isEmpty()) {
      lines.accept("    presets: " + String.join(", ", names));
    }
  }

  private static String values(Parameter parameter) {
    String range =
        parameter.isNumber()
            ? number(parameter.min()) + " to " + number(parameter.max()) + unit(parameter)
            : parameter.choices().isEmpty()
                ? parameter.type() == boolean.class ? "true or false" : "text"
                : String.join(", ", parameter.choices());
    return range + " [" + defaultValue(parameter) + "]";
  }

  private static String unit(Parameter parameter) {
    return parameter.unit().isEmpty() || parameter.unit().equals("1") ? "" : " " + parameter.unit();
  }

  private static String defaultValue(Parameter parameter) {
    Object value = parameter.defaultValue();
    if (value instanceof Enum<?> constant) {
      return constant.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }
    return value instanceof Double number ? number(number) : String.valueOf(value);
  }

  private static String number(double value) {
    return value == Math.rint(value) && Math.abs(value) < 1e15
        ? Long.toString((long) value)
        : Double.toString(value);
  }
}
