package haltere.core.settings;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.stream.Collectors;

/**
 * Settings as the plain values of a JSON object, and back. Nested records are nested objects; an
 * enum is its name in lower case; missing values keep their defaults.
 *
 * @since 0.1
 */
public final class SettingsJson {
  private SettingsJson() {}

  /**
   * All values of a record.
   *
   * @param settings a settings record
   * @param schema its schema
   * @param <S> the record
   * @return maps, numbers, booleans and strings, in the order of the record
   */
  public static <S extends Record> Map<String, Object> toMap(S settings, SettingsSchema<S> schema) {
    Map<String, Object> root = new LinkedHashMap<>();
    for (Parameter parameter : schema.parameters()) {
      Map<String, Object> object = root;
      String[] path = parameter.name().split("\\.");
      for (int i = 0; i < path.length - 1; i++) {
        object = child(object, path[i]);
      }
      Object value = schema.get(settings, parameter.name());
      object.put(path[path.length - 1], value instanceof Enum<?> ? Parameter.text(value) : value);
    }
    return root;
  }

  @SuppressWarnings("unchecked")
  private static Map<String, Object> child(Map<String, Object> object, String name) {
    return (Map<String, Object>) object.computeIfAbsent(name, key -> new LinkedHashMap<>());
  }

  /**
   * A record from the values of a JSON object.
   *
   * @param values names and values; missing ones keep their defaults
   * @param schema the record's schema
   * @param <S> the record
   * @return a valid record
   * @throws SettingsProblem for a name that does not exist or a value out of range
   */
  public static <S extends Record> S fromMap(Map<?, ?> values, SettingsSchema<S> schema) {
    Map<String, Object> flat = new LinkedHashMap<>();
    flatten(values, "", flat, schema);
    return schema.with(schema.defaults(), flat);
  }

  /**
   * A record from the values of a JSON object of any version. Renamed settings keep their values;
   * deleted settings are ignored.
   *
   * @param values names and values; missing ones keep their defaults
   * @param schema the record's schema
   * @param notes receives a line with the replacements of former names, if there are any
   * @param <S> the record
   * @return a valid record
   * @throws SettingsProblem for a name that has never existed or a value out of range
   */
  public static <S extends Record> S fromMap(
      Map<?, ?> values, SettingsSchema<S> schema, Consumer<String> notes) {
    Map<String, Object> flat = new LinkedHashMap<>();
    flatten(values, "", flat, schema);
    Map<String, Object> present = new LinkedHashMap<>();
    Map<String, List<String>> formerNames = new LinkedHashMap<>();
    flat.forEach(
        (name, value) -> {
          String successor = schema.has(name) ? name : schema.successor(name);
          if (successor == null || schema.has(successor)) {
            present.put(successor == null ? name : successor, value);
          }
          if (successor != null && !successor.equals(name)) {
            formerNames.computeIfAbsent(successor, key -> new ArrayList<>()).add(name);
          }
        });
    if (!formerNames.isEmpty()) {
      notes.accept(
          formerNames.entrySet().stream()
              .map(entry -> String.join(", ", entry.getValue()) + " -> " + entry.getKey())
              .collect(Collectors.joining("; ", "settings of an earlier version: ", "")));
    }
    return schema.with(schema.defaults(), present);
  }

  private static void flatten(
      Map<?, ?> values, String prefix, Map<String, Object> flat, SettingsSchema<?> schema) {
    for (Map.Entry<?, ?> entry : values.entrySet()) {
      String name = prefix + entry.getKey();
      if (entry.getValue() instanceof Map<?, ?> nested && schema.isGroup(name)) {
        flatten(nested, name + ".", flat, schema);
      } else {
        flat.put(name, entry.getValue());
      }
    }
  }
}
