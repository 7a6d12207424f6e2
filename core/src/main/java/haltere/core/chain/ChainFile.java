package haltere.core.chain;

import haltere.core.event.SensorGeometry;
import haltere.core.json.JsonProblem;
import haltere.core.json.internal.Json;
import haltere.core.settings.SettingsJson;
import haltere.core.settings.SettingsProblem;
import haltere.core.settings.SettingsSchema;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;

/**
 * A chain as JSON: the filters' names in order, whether they are on, and their settings.
 *
 * <pre>{@code
 * {"filters": [
 *   {"filter": "background-activity", "settings": {"correlationUs": 25000}},
 *   {"filter": "refractory", "enabled": false},
 *   {"name": "tracking", "filters": [{"filter": "cluster-tracker"}]}
 * ]}
 * }</pre>
 *
 * <p>Missing settings have their defaults, so chains of earlier versions are read. A note has the
 * replacements of renamed and deleted settings.
 *
 * <p>Thread rule: all methods may be called from any thread.
 *
 * @since 0.1
 */
public final class ChainFile {
  private ChainFile() {}

  /**
   * Reads a chain.
   *
   * @param file JSON
   * @param geometry the sensor whose events the chain will see
   * @return a chain of new filters
   * @throws JsonProblem if the file is not JSON or not a chain; the message names the file
   * @throws IOException if the file cannot be read
   */
  public static FilterChain read(Path file, SensorGeometry geometry) throws IOException {
    return read(file, geometry, note -> {});
  }

  /**
   * Reads a chain.
   *
   * @param file JSON
   * @param geometry the sensor whose events the chain will see
   * @param notes receives a line for each filter with settings of an earlier version
   * @return a chain of new filters
   * @throws JsonProblem if the file is not JSON or not a chain; the message names the file
   * @throws IOException if the file cannot be read
   */
  public static FilterChain read(Path file, SensorGeometry geometry, Consumer<String> notes)
      throws IOException {
    return chain(Json.read(file), file.toString(), geometry, notes);
  }

  /**
   * Reads a chain from text.
   *
   * @param text JSON
   * @param name of the text in error messages
   * @param geometry the sensor whose events the chain will see
   * @return a chain of new filters
   * @throws JsonProblem if the text is not a chain
   */
  public static FilterChain parse(String text, String name, SensorGeometry geometry)
      throws JsonProblem {
    return chain(Json.parse(text, name), name, geometry, note -> {});
  }

  private static FilterChain chain(
      Object value, String name, SensorGeometry geometry, Consumer<String> notes)
      throws JsonProblem {
    try {
      return nested(value, geometry, "", note -> notes.accept(name + ": " + note));
    } catch (SettingsProblem | ChainProblem problem) {
      throw (JsonProblem) new JsonProblem(name + ": " + problem.getMessage()).initCause(problem);
    }
  }

  /** A chain at a position: empty for the outermost, else such as "filter 3". */
  private static FilterChain nested(
      Object value, SensorGeometry geometry, String location, Consumer<String> notes) {
    String what = location.isEmpty() ? "the chain" : location;
    Map<?, ?> object = object(value, what);
    requireKeys(object, what, List.of("filters", "name", "enabled", "comment"));
    if (!(object.get("filters") instanceof List<?> entries)) {
      throw new ChainProblem(what + " needs \"filters\", an array of filters");
    }
    FilterChain chain = new FilterChain(geometry);
    for (int i = 0; i < entries.size(); i++) {
      String entryLocation = (location.isEmpty() ? "" : location + ", ") + "filter " + (i + 1);
      addStage(chain, object(entries.get(i), entryLocation), entryLocation, notes);
    }
    return chain;
  }

  private static void requireKeys(Map<?, ?> object, String what, List<String> known) {
    for (Object key : object.keySet()) {
      if (!known.contains(key)) {
        throw new ChainProblem(
            what + " has no \"" + key + "\"; it may have \"" + String.join("\", \"", known) + "\"");
      }
    }
  }

  private static void addStage(
      FilterChain chain, Map<?, ?> entry, String location, Consumer<String> notes) {
    boolean enabled = enabled(entry, location);
    if (entry.containsKey("filters")) {
      Object name = entry.get("name");
      chain.add(
          name == null ? "chain" : name.toString(),
          nested(entry, chain.geometry(), location, notes),
          enabled,
          chain.stages().size());
      return;
    }
    requireKeys(entry, location, List.of("filter", "enabled", "settings", "comment"));
    if (!(entry.get("filter") instanceof String kind)) {
      throw new ChainProblem(location + " needs \"filter\", the name of a filter");
    }
    Object settings = entry.get("settings");
    String stage = location + " (" + kind + "): ";
    EventFilter filter;
    try {
      filter =
          create(
              Filters.named(kind),
              chain.geometry(),
              settings == null ? Map.of() : object(settings, "its settings"),
              note -> notes.accept(stage + note));
    } catch (SettingsProblem | ChainProblem problem) {
      throw (ChainProblem) new ChainProblem(stage + problem.getMessage()).initCause(problem);
    }
    chain.add(kind, filter, enabled, chain.stages().size());
  }

  private static boolean enabled(Map<?, ?> entry, String location) {
    Object enabled = entry.containsKey("enabled") ? entry.get("enabled") : Boolean.TRUE;
    if (!(enabled instanceof Boolean flag)) {
      throw new ChainProblem(location + ": \"enabled\" is true or false, not " + enabled);
    }
    return flag;
  }

  private static <S extends Record> EventFilter create(
      FilterProvider<S> provider,
      SensorGeometry geometry,
      Map<?, ?> settings,
      Consumer<String> notes) {
    S valid = SettingsJson.fromMap(settings, provider.schema(), notes);
    return Filters.create(provider, () -> provider.create(geometry, valid));
  }

  private static Map<?, ?> object(Object value, String what) {
    if (value instanceof Map<?, ?> map) {
      return map;
    }
    throw new ChainProblem(what + " must be a JSON object, it is " + value);
  }

  /**
   * A chain as JSON text.
   *
   * @param chain a chain
   * @return text that {@link #parse} makes an equal chain from
   */
  public static String write(FilterChain chain) {
    return Json.write(toMap(chain)) + "\n";
  }

  private static Map<String, Object> toMap(FilterChain chain) {
    List<Object> entries = new ArrayList<>();
    for (ChainStage stage : chain.stages()) {
      Map<String, Object> entry = new LinkedHashMap<>();
      if (stage.filter() instanceof FilterChain nested) {
        entry.put("name", stage.kind());
        entry.put("enabled", stage.isEnabled());
        entry.putAll(toMap(nested));
      } else {
        entry.put("filter", stage.kind());
        entry.put("enabled", stage.isEnabled());
        if (stage.filter() instanceof ConfigurableFilter<?> configurable) {
          Map<String, Object> settings = settings(configurable.settings());
          if (!settings.isEmpty()) {
            entry.put("settings", settings);
          }
        }
      }
      entries.add(entry);
    }
    Map<String, Object> object = new LinkedHashMap<>();
    object.put("filters", entries);
    return object;
  }

  @SuppressWarnings("unchecked")
  private static <S extends Record> Map<String, Object> settings(S settings) {
    return SettingsJson.toMap(settings, SettingsSchema.of((Class<S>) settings.getClass()));
  }
}
