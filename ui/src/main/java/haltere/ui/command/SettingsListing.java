package haltere.ui.command;

import haltere.core.json.internal.Json;
import haltere.core.settings.Parameter;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;

/** Lists what can be set: a name, a sentence, and a line for each setting; or all that as JSON. */
final class SettingsListing {
  private final Consumer<String> lines;
  private final List<Object> entries = new ArrayList<>();
  private boolean begun;

  private SettingsListing(Consumer<String> lines) {
    this.lines = lines;
  }

  /**
   * Lists entries.
   *
   * @param command receives the lines
   * @param json the key of the entries in one JSON object, or empty for lines of text
   * @param adding adds the entries
   */
  static void list(Subcommand command, Optional<String> json, Consumer<SettingsListing> adding) {
    SettingsListing listing = new SettingsListing(json.isPresent() ? line -> {} : command::result);
    adding.accept(listing);
    json.ifPresent(key -> command.result(Json.write(Map.of(key, listing.entries))));
  }

  /**
   * Adds an entry, an empty line behind the one before.
   *
   * @param name what it is called
   * @param description a sentence
   * @param parameters its settings
   * @param presets names of its presets
   */
  void add(String name, String description, List<Parameter> parameters, Set<String> presets) {
    Map<String, Object> entry = new LinkedHashMap<>();
    entry.put("name", name);
    entry.put("description", description);
    entry.put("settings", parameters.stream().map(SettingsListing::json).toList());
    entry.put("presets", List.copyOf(presets));
    entries.add(entry);
    addLines(name, description, parameters);
    if (!presets.isEmpty()) {
      lines.accept("    presets: " + String.join(", ", presets));
    }
  }

  private void addLines(String name, String description, List<Parameter> parameters) {
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

  /** A number has a range and a unit, any other setting its choices if there are some. */
  private static Map<String, Object> json(Parameter parameter) {
    Map<String, Object> json = new LinkedHashMap<>();
    json.put("name", parameter.name());
    if (parameter.isNumber()) {
      json.put("min", parameter.min());
      json.put("max", parameter.max());
      json.put("unit", parameter.unit());
    } else if (!parameter.choices().isEmpty()) {
      json.put("choices", parameter.choices());
    }
    Object value = parameter.defaultValue();
    boolean isPlain = value instanceof Number || value instanceof Boolean;
    json.put("default", isPlain ? value : defaultValue(parameter));
    json.put("help", parameter.help());
    return json;
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
