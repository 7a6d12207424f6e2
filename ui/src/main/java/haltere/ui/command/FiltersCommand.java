package haltere.ui.command;

import haltere.core.chain.FilterProvider;
import haltere.core.chain.Filters;
import haltere.core.settings.Parameter;
import java.util.List;
import java.util.Locale;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/** Lists the filters and their settings. */
@Command(
    name = "filters",
    description = "List the filters with their settings: unit, range, default and meaning.")
final class FiltersCommand extends Subcommand {
  @Parameters(arity = "0..*", paramLabel = "NAME", description = "Only these filters.")
  List<String> names = List.of();

  FiltersCommand(Surroundings surroundings) {
    super(surroundings);
  }

  @Override
  public Integer call() {
    for (String name : names) {
      if (!Filters.all().containsKey(name)) {
        throw wrongArguments(
            "there is no filter named "
                + name
                + "; there are "
                + String.join(", ", Filters.all().keySet()));
      }
    }
    String separator = "";
    for (FilterProvider<?> provider : Filters.all().values()) {
      if (names.isEmpty() || names.contains(provider.name())) {
        surroundings().out().print(separator);
        describe(provider);
        separator = "\n";
      }
    }
    return OK;
  }

  private void describe(FilterProvider<?> provider) {
    result(provider.name());
    result("  " + provider.description());
    List<Parameter> parameters = provider.schema().parameters();
    int nameWidth = 0;
    int rangeWidth = 0;
    for (Parameter parameter : parameters) {
      nameWidth = Math.max(nameWidth, parameter.name().length());
      rangeWidth = Math.max(rangeWidth, values(parameter).length());
    }
    for (Parameter parameter : parameters) {
      result(
          String.format(
              Locale.ROOT,
              "    %-" + nameWidth + "s  %-" + rangeWidth + "s  %s",
              parameter.name(),
              values(parameter),
              parameter.help()));
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
