package haltere.ui.command;

import haltere.core.json.internal.Json;
import haltere.core.settings.Parameter;
import haltere.ui.command.terminal.Quantities;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Lists what can be set: a name, a sentence, and a line for each setting; or all that as JSON. */
abstract class SettingsListing extends Subcommand {
  @Parameters(arity = "0..*", paramLabel = "NAME", description = "Only those of these names.")
  List<String> names = List.of();

  @Option(
      names = "--json",
      description =
          "Print one JSON object: name, description, settings and presets of each, by its kind.")
  boolean json;

  private boolean begun;

  /** What can be set of one. */
  record Entry(String description, List<Parameter> parameters, Set<String> presets) {}

  /** Names of all that there are. */
  abstract Set<String> all();

  /** The one of a name; a {@link RuntimeException} says in a line that there is none. */
  abstract Entry entry(String name);

  @Override
  public Integer call() {
    try {
      names.forEach(this::entry);
    } catch (IllegalArgumentException problem) {
      throw wrongArguments(problem.getMessage());
    }
    List<String> listed =
        all().stream().filter(name -> names.isEmpty() || names.contains(name)).toList();
    if (json) {
      result(Json.write(Map.of(spec.name(), listed.stream().map(this::object).toList())));
    } else {
      listed.forEach(this::print);
    }
    return OK;
  }

  private Object object(String name) {
    Entry entry = entry(name);
    Map<String, Object> object = new LinkedHashMap<>();
    object.put("name", name);
    object.put("description", entry.description());
    object.put("settings", entry.parameters().stream().map(SettingsListing::json).toList());
    object.put("presets", List.copyOf(entry.presets()));
    return object;
  }

  private void print(String name) {
    if (begun) {
      result("");
    }
    begun = true;
    Entry entry = entry(name);
    result(name);
    result("  " + entry.description());
    List<List<String>> rows =
        entry.parameters().stream()
            .map(setting -> List.of(setting.name(), values(setting), setting.help()))
            .toList();
    Quantities.table("    ", rows).forEach(this::result);
    if (!entry.presets().isEmpty()) {
      result("    presets: " + String.join(", ", entry.presets()));
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
