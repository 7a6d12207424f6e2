package haltere.device.model;

import haltere.core.camera.Biases;
import haltere.core.camera.Configuration;
import haltere.core.settings.Parameter;
import java.math.BigDecimal;
import java.util.List;
import java.util.stream.Collectors;

/** Common methods of the settings of all cameras. */
final class Settings {
  private Settings() {}

  static Parameter flag(String name, String help, boolean defaultValue) {
    return new Parameter(
        name,
        boolean.class,
        "",
        Double.NEGATIVE_INFINITY,
        Double.POSITIVE_INFINITY,
        false,
        help,
        defaultValue,
        List.of(),
        "");
  }

  static Parameter choice(
      String name, String help, Class<?> type, Object defaultValue, List<String> choices) {
    return new Parameter(
        name,
        type,
        "",
        Double.NEGATIVE_INFINITY,
        Double.POSITIVE_INFINITY,
        false,
        help,
        defaultValue,
        choices,
        "");
  }

  /** The parameter of a name. */
  static Parameter named(List<Parameter> parameters, String name) {
    return parameters.stream()
        .filter(parameter -> parameter.name().equals(name))
        .findFirst()
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    "there is no setting "
                        + name
                        + "; there are "
                        + parameters.stream()
                            .map(Parameter::name)
                            .collect(Collectors.joining(", "))));
  }

  /** All settings and biases, a line each. */
  static String text(String head, Configuration configuration, Biases biases) {
    StringBuilder text = new StringBuilder(head).append('\n');
    for (Parameter parameter : configuration.parameters()) {
      append(text, parameter, parameter.name(), configuration.get(parameter.name()));
    }
    for (Parameter parameter : biases.parameters()) {
      append(
          text,
          parameter,
          "bias." + parameter.name(),
          BigDecimal.valueOf(biases.get(parameter.name())).stripTrailingZeros().toPlainString());
    }
    return text.toString();
  }

  private static void append(StringBuilder text, Parameter parameter, String name, Object value) {
    text.append(name).append(" = ").append(value);
    if (!parameter.unit().isEmpty()) {
      text.append(' ').append(parameter.unit());
    }
    text.append('\n');
  }
}
