package haltere.ui.command;

import haltere.core.json.internal.Json;
import haltere.core.settings.Parameter;
import haltere.core.settings.SettingsProvider;
import haltere.ui.command.terminal.Quantities;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.function.Supplier;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Lists names with a description and a line for each setting, or the same as JSON. */
abstract class SettingsListing extends Subcommand {
  @Parameters(arity = "0..*", paramLabel = "NAME", description = "List only these names.")
  List<String> names = List.of();

  @Option(
      names = "--json",
      description =
          "Print one JSON object: name, description, settings and presets of each, by its kind.")
  boolean json;

  private boolean started;

  private final Supplier<? extends Map<String, ? extends SettingsProvider<?>>> all;
  private final Function<String, ? extends SettingsProvider<?>> named;

  /** A list of some providers by name; rejects an unknown name. */
  SettingsListing(
      Supplier<? extends Map<String, ? extends SettingsProvider<?>>> all,
      Function<String, ? extends SettingsProvider<?>> named) {
    this.all = all;
    this.named = named;
  }

  @Override
  public Integer call() {
    try {
      names.forEach(named::apply);
    } catch (IllegalArgumentException problem) {
      throw wrongArguments(problem.getMessage());
    }
    List<? extends SettingsProvider<?>> listed =
        all.get().values().stream()
            .filter(each -> names.isEmpty() || names.contains(each.name()))
            .toList();
    if (json) {
      List<?> objects = listed.stream().map(SettingsListing::object).toList();
      result(Json.write(Map.of(spec.name(), objects)));
    } else {
      listed.forEach(this::print);
    }
    return OK;
  }

  private static Object object(SettingsProvider<?> entry) {
    Map<String, Object> object = new LinkedHashMap<>();
    object.put("name", entry.name());
    object.put("description", entry.description());
    object.put(
        "settings", entry.schema().parameters().stream().map(SettingsListing::json).toList());
    object.put("presets", List.copyOf(entry.presets().keySet()));
    return object;
  }

  private void print(SettingsProvider<?> entry) {
    if (started) {
      result("");
    }
    started = true;
    result(entry.name());
    result("  " + entry.description());
    List<List<String>> rows =
        entry.schema().parameters().stream()
            .map(setting -> List.of(setting.name(), values(setting), setting.help()))
            .toList();
    Quantities.table("    ", rows).forEach(this::result);
    if (!entry.presets().isEmpty()) {
      result("    presets: " + String.join(", ", entry.presets().keySet()));
    }
  }

  /** A number has a range and a unit, any other setting its choices, if any. */
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
    json.put("default", isPlain ? value : Parameter.text(value));
    json.put("help", parameter.help());
    return json;
  }

  private static String values(Parameter parameter) {
    String ends = Parameter.text(parameter.min()) + " to " + Parameter.text(parameter.max());
    String range =
        parameter.isNumber()
            ? ends + unit(parameter)
            : parameter.choices().isEmpty()
                ? parameter.type() == boolean.class ? "true or false" : "text"
                : String.join(", ", parameter.choices());
    return range + " [" + Parameter.text(parameter.defaultValue()) + "]";
  }

  private static String unit(Parameter parameter) {
    return parameter.unit().isEmpty() || parameter.unit().equals("1") ? "" : " " + parameter.unit();
  }
}
