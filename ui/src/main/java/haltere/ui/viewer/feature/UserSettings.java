package haltere.ui.viewer.feature;

import haltere.core.format.AtomicFile;
import haltere.core.json.internal.Json;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import javafx.beans.property.Property;

/**
 * A user's settings in one readable and editable JSON file. Unreadable values are ignored, unknown
 * ones are preserved.
 *
 * <p>Thread rule: {@link #load} and {@link #save} on any thread but JavaFX's, the rest on the
 * JavaFX thread. Saving sees a consistent copy.
 */
public final class UserSettings {
  /** A saved property, by its value for JSON. */
  private record StoredValue(Supplier<Object> value, Consumer<Object> consumer) {}

  private final Optional<Path> file;
  private final Map<String, Object> values;
  private final Map<String, StoredValue> properties = new HashMap<>();

  /** A change of a value, from the one that was saved. */
  private record ValueChange(Object before, Object now) {
    /** The value after the change of another one, of whose map only changed entries are changed. */
    Object of(Object there) {
      if (!(there instanceof Map<?, ?> others
          && before instanceof Map<?, ?> was
          && now instanceof Map<?, ?> is)) {
        return now;
      }
      Map<Object, Object> all = new LinkedHashMap<>(others);
      all.keySet().removeIf(key -> was.containsKey(key) && !is.containsKey(key));
      is.forEach(
          (key, value) -> all.compute(key, (k, old) -> value.equals(was.get(k)) ? old : value));
      return all;
    }
  }

  /** Values that were changed and are not saved yet. */
  private final Map<String, ValueChange> unsaved = new ConcurrentHashMap<>();

  private UserSettings(Optional<Path> file, Map<String, Object> values) {
    this.file = file;
    this.values = values;
  }

  /** Settings without a file. */
  public static UserSettings inMemory() {
    return new UserSettings(Optional.empty(), new LinkedHashMap<>());
  }

  /** The settings in a folder; defaults if there are none or they cannot be read. */
  public static UserSettings load(Path folder) {
    Path file = folder.resolve("viewer.json");
    Map<String, Object> values = new LinkedHashMap<>();
    try {
      if (Files.exists(file) && Json.read(file) instanceof Map<?, ?> found) {
        found.forEach((name, value) -> values.put(name.toString(), value));
      }
    } catch (IOException unreadable) {
      // default settings; the file remains until a change
      values.clear();
    }
    return new UserSettings(Optional.of(file), values);
  }

  /** The file of the settings. */
  public Optional<Path> file() {
    return file;
  }

  /** A value as JSON has it: text, Long, Double, Boolean, List or Map. */
  public Optional<Object> get(String name) {
    return Optional.ofNullable(values.get(name));
  }

  /** A copy of a value that is a map; empty if it is none. */
  public Map<String, Object> map(String name) {
    Map<String, Object> copy = new LinkedHashMap<>();
    if (values.get(name) instanceof Map<?, ?> kept) {
      kept.forEach((key, value) -> copy.put(key.toString(), value));
    }
    return copy;
  }

  /** Sets a value that JSON can hold. */
  public void put(String name, Object value) {
    Object before = values.put(name, value);
    if (!value.equals(before)) {
      ValueChange change = new ValueChange(before == null ? Map.of() : before, value);
      unsaved.merge(name, change, (first, last) -> new ValueChange(first.before(), last.now()));
    }
  }

  /**
   * Restores the saved value of a property, and saves later values.
   *
   * @param write converts a value to JSON
   * @param read converts it back; an exception means an invalid value
   */
  public <T> void keep(
      String name, Property<T> property, Function<T, Object> write, Function<Object, T> read) {
    StoredValue made =
        new StoredValue(
            () -> write.apply(property.getValue()), value -> property.setValue(read.apply(value)));
    properties.put(name, made);
    get(name).ifPresent(value -> choose(Map.of(name, value)));
    property.subscribe((was, is) -> put(name, write.apply(is)));
  }

  /**
   * The present values of some settings.
   *
   * @param kinds prefixes of the names
   * @return values by name, as {@link #get} has them
   */
  public Map<String, Object> chosen(String... kinds) {
    Map<String, Object> chosen = new TreeMap<>();
    properties.forEach(
        (name, property) -> {
          if (Arrays.stream(kinds).anyMatch(name::startsWith)) {
            chosen.put(name, property.value().get());
          }
        });
    return chosen;
  }

  /** Sets saved properties to other values; unknown and invalid ones are ignored. */
  public void choose(Map<?, ?> wanted) {
    wanted.forEach(
        (name, value) -> {
          StoredValue property = properties.get(name);
          try {
            if (property != null) {
              property.consumer().accept(value);
            }
          } catch (RuntimeException ofNoUse) {
            // edited manually or by another version: the default remains
            values.remove(name);
          }
        });
  }

  /** Keeps a flag. */
  public void keep(String name, Property<Boolean> property) {
    keep(name, property, value -> value, Boolean.class::cast);
  }

  /** Writes changed values into the file, which another window may have changed elsewhere. */
  public void save() throws IOException {
    Map<String, ValueChange> changed = Map.copyOf(unsaved);
    if (file.isEmpty() || changed.isEmpty()) {
      return;
    }
    Path folder = file.get().toAbsolutePath().getParent();
    Files.createDirectories(folder);
    Map<String, Object> all = load(folder).values;
    changed.forEach((name, change) -> all.put(name, change.of(all.getOrDefault(name, Map.of()))));
    AtomicFile.write(file.get(), Json.write(all) + "\n", true);
    unsaved.entrySet().removeAll(changed.entrySet());
  }

  /** Whether there are unsaved changes. */
  public boolean hasChanged() {
    return !unsaved.isEmpty();
  }
}
