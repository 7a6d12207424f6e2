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
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import javafx.beans.property.Property;

/**
 * What a user has chosen, kept from one start to the next in one JSON file that a person can read
 * and change. What cannot be read is left out; what this version does not know is kept.
 *
 * <p>Thread rule: {@link #load} and {@link #save} on any thread but JavaFX's, the rest on the
 * JavaFX thread. Saving sees a consistent copy.
 */
public final class UserSettings {
  /** A property that is kept, by its value for JSON. */
  private record Kept(Supplier<Object> value, Consumer<Object> consumer) {}

  private final Optional<Path> file;
  private final Map<String, Object> values;
  private final Map<String, Kept> properties = new HashMap<>();

  /** What is to be written; empty if the file has it all. */
  private volatile Optional<Map<String, Object>> unsaved = Optional.empty();

  private UserSettings(Optional<Path> file, Map<String, Object> values) {
    this.file = file;
    this.values = values;
  }

  /** Settings that nobody keeps. */
  public static UserSettings inMemory() {
    return new UserSettings(Optional.empty(), new LinkedHashMap<>());
  }

  /** The settings in a folder; the usual ones if there are none or they cannot be read. */
  public static UserSettings load(Path folder) {
    Path file = folder.resolve("viewer.json");
    Map<String, Object> values = new LinkedHashMap<>();
    try {
      if (Files.exists(file) && Json.read(file) instanceof Map<?, ?> found) {
        found.forEach((name, value) -> values.put(name.toString(), value));
      }
    } catch (IOException unreadable) {
      // the usual settings do; the file is kept until something is changed
      values.clear();
    }
    return new UserSettings(Optional.of(file), values);
  }

  /** Where they are kept. */
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
    if (!value.equals(values.put(name, value))) {
      unsaved = Optional.of(new LinkedHashMap<>(values));
    }
  }

  /**
   * Gives a property the value that was kept, and keeps every value that it gets.
   *
   * @param write brings a value to what JSON can hold
   * @param read brings it back; what it throws means that the value is of no use
   */
  public <T> void keep(
      String name, Property<T> property, Function<T, Object> write, Function<Object, T> read) {
    Kept made =
        new Kept(
            () -> write.apply(property.getValue()), value -> property.setValue(read.apply(value)));
    properties.put(name, made);
    get(name).ifPresent(value -> choose(Map.of(name, value)));
    property.subscribe((was, is) -> put(name, write.apply(is)));
  }

  /**
   * What is chosen now of some kinds.
   *
   * @param kinds how the names begin
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

  /** Gives kept properties other values; what is unknown or of no use is left out. */
  public void choose(Map<?, ?> wanted) {
    wanted.forEach(
        (name, value) -> {
          Kept property = properties.get(name);
          try {
            if (property != null) {
              property.consumer().accept(value);
            }
          } catch (RuntimeException ofNoUse) {
            // written by a person or by another version: the usual value stays
            values.remove(name);
          }
        });
  }

  /** Keeps a flag. */
  public void keep(String name, Property<Boolean> property) {
    keep(name, property, value -> value, Boolean.class::cast);
  }

  /** Writes the file if something has changed; its folder is made. */
  public void save() throws IOException {
    Optional<Map<String, Object>> changed = unsaved;
    if (file.isEmpty() || changed.isEmpty()) {
      return;
    }
    Files.createDirectories(file.get().toAbsolutePath().getParent());
    AtomicFile.write(file.get(), Json.write(changed.get()) + "\n", true);
    if (unsaved.equals(changed)) {
      unsaved = Optional.empty();
    }
  }

  /** Whether there is something to save. */
  public boolean hasChanged() {
    return unsaved.isPresent();
  }
}
