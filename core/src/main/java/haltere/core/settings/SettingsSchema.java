package haltere.core.settings;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;

/**
 * The schema of a settings record, read once from its annotated components. Panel, command line,
 * saved chains and manual use it.
 *
 * <p>A settings record has components of type int, long, double, boolean, String, an enum or
 * another settings record; every leaf has {@link Help} and every number {@link Range} and {@link
 * Unit}; a static method {@code defaults()} returns the default values; its compact constructor
 * calls {@link #validate} with all of its components, which checks those of nested records too.
 *
 * <p>A record with renamed settings may have a static method {@code formerNames()}: a map from the
 * former name of a setting, or of a group, to its present name or to a sentence with its
 * replacement. Files may have such names, see {@link SettingsJson}; elsewhere they are explained.
 *
 * <p>Thread rule: immutable, may be used from any thread.
 *
 * @param <S> the settings record
 * @since 0.1
 */
public final class SettingsSchema<S extends Record> {
  private static final Map<Class<?>, SettingsSchema<?>> CACHE = new ConcurrentHashMap<>();
  private static final Map<Class<?>, List<Parameter>> RANGES = new ConcurrentHashMap<>();

  /** Components of a record by name, in order; the JVM makes them anew whenever it is asked. */
  private static final ClassValue<Map<String, RecordComponent>> COMPONENTS =
      new ClassValue<>() {
        @Override
        protected Map<String, RecordComponent> computeValue(Class<?> type) {
          Map<String, RecordComponent> components = new LinkedHashMap<>();
          for (RecordComponent component : type.getRecordComponents()) {
            component.getAccessor().setAccessible(true);
            components.put(component.getName(), component);
          }
          return Collections.unmodifiableMap(components);
        }
      };

  private final Class<S> type;
  private final S defaults;
  private final Map<String, Parameter> parameters;
  private final Map<String, String> formerNames = new LinkedHashMap<>();

  private SettingsSchema(Class<S> type) {
    this.type = type;
    this.defaults = defaultsOf(type);
    Map<String, Parameter> found = new LinkedHashMap<>();
    collect(type, defaults, "", found);
    parameters = Collections.unmodifiableMap(found);
    collectFormerNames(type, "");
  }

  /**
   * The schema of a settings record.
   *
   * @param type the record's class
   * @param <S> the record
   * @return always the same schema for a class
   * @throws IllegalStateException if the record is not a well-formed settings record
   */
  @SuppressWarnings("unchecked")
  public static <S extends Record> SettingsSchema<S> of(Class<S> type) {
    SettingsSchema<?> cached = CACHE.get(type);
    if (cached == null) {
      SettingsSchema<?> made = new SettingsSchema<>(type);
      cached = CACHE.putIfAbsent(type, made);
      cached = cached == null ? made : cached;
    }
    return (SettingsSchema<S>) cached;
  }

  /**
   * Checks the values of a record's components against their ranges; the record's compact
   * constructor calls this.
   *
   * @param type the record's class
   * @param values all components, in order
   * @throws SettingsProblem if one is out of its range, NaN or null
   */
  public static void validate(Class<? extends Record> type, Object... values) {
    List<Parameter> components = RANGES.get(type);
    if (components == null) {
      components = components(type);
      RANGES.put(type, components);
    }
    if (components.size() != values.length) {
      throw new IllegalStateException(
          type.getSimpleName() + " has " + components.size() + " components, not " + values.length);
    }
    for (int i = 0; i < values.length; i++) {
      components.get(i).check(values[i]);
      if (values[i] instanceof Record nested) {
        Stream<String> names = COMPONENTS.get(nested.getClass()).keySet().stream();
        validate(nested.getClass(), names.map(name -> component(nested, name)).toArray());
      }
    }
  }

  /**
   * The settings record.
   *
   * @return its class
   */
  public Class<S> type() {
    return type;
  }

  /**
   * The default settings.
   *
   * @return what the record's own {@code defaults()} returned
   */
  public S defaults() {
    return defaults;
  }

  /**
   * All settings in the order of the record, those of nested records at their place.
   *
   * @return unmodifiable
   */
  public List<Parameter> parameters() {
    return List.copyOf(parameters.values());
  }

  /**
   * One setting.
   *
   * @param name dotted path
   * @return the setting
   * @throws SettingsProblem if there is none of this name, listing those there are
   */
  public Parameter parameter(String name) {
    Parameter parameter = parameters.get(name);
    if (parameter == null) {
      String successor = successor(name);
      throw new SettingsProblem(
          successor != null
              ? "there is no setting " + name + " any more: " + successor
              : "there is no setting "
                  + name
                  + (parameters.isEmpty()
                      ? ", there are none here"
                      : "; there are " + String.join(", ", parameters.keySet())));
    }
    return parameter;
  }

  /**
   * Replacement of a setting of an earlier version.
   *
   * @param name dotted path that the setting had
   * @return the present name of the setting, or a sentence; null for any other name
   */
  String successor(String name) {
    for (String former = name; ; former = former.substring(0, former.lastIndexOf('.'))) {
      String successor = formerNames.get(former);
      if (successor != null || former.indexOf('.') < 0) {
        return successor;
      }
    }
  }

  /** Whether settings of an earlier version, or of this one, were in a group of this name. */
  boolean isGroup(String name) {
    String start = name + ".";
    return Stream.concat(parameters.keySet().stream(), formerNames.keySet().stream())
        .anyMatch(one -> one.startsWith(start));
  }

  /** Whether there is a setting of this name. */
  boolean has(String name) {
    return parameters.containsKey(name);
  }

  /**
   * Reads one value.
   *
   * @param settings a record
   * @param name dotted path
   * @return its value
   */
  public Object get(S settings, String name) {
    parameter(name);
    Object value = settings;
    for (String step : name.split("\\.")) {
      value = component(value, step);
    }
    return value;
  }

  /**
   * The same settings with one value replaced.
   *
   * @param settings a record, unchanged
   * @param name dotted path
   * @param value a value of the setting's type, or text that can be read as one
   * @return a new record
   * @throws SettingsProblem if there is no such setting or it cannot take the value
   */
  public S with(S settings, String name, Object value) {
    return with(settings, Collections.singletonMap(name, value));
  }

  /**
   * The same settings with some values replaced together; only the result must be valid.
   *
   * @param settings a record, unchanged
   * @param values by dotted path: values of the setting's type, or texts that can be read as one
   * @return a new record
   * @throws SettingsProblem for the first one that does not exist or cannot take its value
   */
  public S with(S settings, Map<String, ?> values) {
    Map<String, Object> converted = new LinkedHashMap<>();
    values.forEach((name, value) -> converted.put(name, parameter(name).convert(value)));
    return type.cast(replaced(settings, "", converted));
  }

  /**
   * Applies {@code name=value} texts, as a command line has them. The last part of a name is
   * sufficient if only one setting ends in it: {@code seed} for {@code run.seed}.
   *
   * @param settings a record, unchanged
   * @param assignments texts with an equals sign
   * @return a new record
   * @throws SettingsProblem for the first one that cannot be applied
   */
  public S withAssignments(S settings, Iterable<String> assignments) {
    Map<String, String> values = new LinkedHashMap<>();
    for (String assignment : assignments) {
      int equals = assignment.indexOf('=');
      if (equals < 1) {
        throw new SettingsProblem("\"" + assignment + "\" is not of the form name=value");
      }
      String name = fullName(assignment.substring(0, equals).trim());
      values.put(name, assignment.substring(equals + 1));
    }
    return with(settings, values);
  }

  private String fullName(String name) {
    if (parameters.containsKey(name)) {
      return name;
    }
    List<String> found = endingIn(name, parameters);
    if (found.size() > 1) {
      throw new SettingsProblem(
          "several settings end in " + name + ": " + String.join(", ", found));
    }
    List<String> former = endingIn(name, formerNames);
    return found.size() == 1 ? found.get(0) : former.size() == 1 ? former.get(0) : name;
  }

  private static List<String> endingIn(String name, Map<String, ?> named) {
    return named.keySet().stream().filter(whole -> whole.endsWith("." + name)).toList();
  }

  /**
   * Names of the settings that differ from the defaults.
   *
   * @param settings a record
   * @return dotted paths, in order
   */
  public List<String> changed(S settings) {
    List<String> changed = new ArrayList<>();
    for (Parameter parameter : parameters.values()) {
      if (!get(settings, parameter.name()).equals(parameter.defaultValue())) {
        changed.add(parameter.name());
      }
    }
    return changed;
  }

  private static Object replaced(Object settings, String prefix, Map<String, Object> newValues) {
    List<Object> values = new ArrayList<>();
    for (String component : COMPONENTS.get(settings.getClass()).keySet()) {
      String name = prefix + component;
      Object old = component(settings, component);
      values.add(
          old instanceof Record nested
              ? replaced(nested, name + ".", newValues)
              : newValues.getOrDefault(name, old));
    }
    return construct(settings.getClass(), values.toArray());
  }

  private static Object construct(Class<?> type, Object[] values) {
    Stream<RecordComponent> components = COMPONENTS.get(type).values().stream();
    Class<?>[] types = components.map(RecordComponent::getType).toArray(Class<?>[]::new);
    try {
      Constructor<?> constructor = type.getDeclaredConstructor(types);
      constructor.setAccessible(true);
      return constructor.newInstance(values);
    } catch (InvocationTargetException thrown) {
      if (thrown.getCause() instanceof RuntimeException cause) {
        throw cause;
      }
      throw new IllegalStateException(thrown.getCause());
    } catch (ReflectiveOperationException broken) {
      throw new IllegalStateException(type + " cannot be constructed", broken);
    }
  }

  private static Object component(Object settings, String name) {
    RecordComponent component = COMPONENTS.get(settings.getClass()).get(name);
    if (component == null) {
      throw new SettingsProblem("there is no setting " + name);
    }
    try {
      return component.getAccessor().invoke(settings);
    } catch (ReflectiveOperationException broken) {
      throw new IllegalStateException(settings.getClass() + "." + name, broken);
    }
  }

  private static <S extends Record> S defaultsOf(Class<S> type) {
    try {
      var method = type.getDeclaredMethod("defaults");
      method.setAccessible(true);
      return type.cast(method.invoke(null));
    } catch (InvocationTargetException thrown) {
      throw new IllegalStateException(
          "the defaults of " + type.getName() + " are not valid: " + thrown.getCause(), thrown);
    } catch (ReflectiveOperationException missing) {
      throw new IllegalStateException(
          type.getName() + " has no static method defaults() without parameters", missing);
    }
  }

  private static void collect(
      Class<?> type, Object defaults, String prefix, Map<String, Parameter> found) {
    for (RecordComponent component : COMPONENTS.get(type).values()) {
      Object value = component(defaults, component.getName());
      String name = prefix + component.getName();
      if (component.getType().isRecord()) {
        collect(component.getType(), value, name + ".", found);
      } else {
        found.put(name, leaf(component, name, value));
      }
    }
  }

  private void collectFormerNames(Class<?> type, String prefix) {
    for (RecordComponent component : COMPONENTS.get(type).values()) {
      if (component.getType().isRecord()) {
        collectFormerNames(component.getType(), prefix + component.getName() + ".");
      }
    }
    try {
      var method = type.getDeclaredMethod("formerNames");
      method.setAccessible(true);
      ((Map<?, ?>) method.invoke(null))
          .forEach(
              (former, successor) -> {
                boolean isSentence = successor.toString().indexOf(' ') >= 0;
                formerNames.put(prefix + former, (isSentence ? "" : prefix) + successor);
              });
    } catch (NoSuchMethodException ignored) {
      // Its settings have always had their names.
    } catch (ReflectiveOperationException broken) {
      throw new IllegalStateException(type + ".formerNames()", broken);
    }
  }

  private static List<Parameter> components(Class<?> type) {
    List<Parameter> components = new ArrayList<>();
    for (RecordComponent component : COMPONENTS.get(type).values()) {
      components.add(
          component.getType().isRecord()
              ? new Parameter(
                  component.getName(),
                  component.getType(),
                  "",
                  Double.NEGATIVE_INFINITY,
                  Double.POSITIVE_INFINITY,
                  false,
                  "",
                  null,
                  List.of(),
                  "")
              : leaf(component, component.getName(), null));
    }
    return List.copyOf(components);
  }

  private static Parameter leaf(RecordComponent component, String name, Object value) {
    Class<?> type = component.getType();
    boolean number = type == int.class || type == long.class || type == double.class;
    if (!number && type != boolean.class && type != String.class && !type.isEnum()) {
      throw new IllegalStateException(
          component.getDeclaringRecord().getName() + "." + name + " has the type " + type);
    }
    Help help = component.getAnnotation(Help.class);
    Range range = component.getAnnotation(Range.class);
    Unit unit = component.getAnnotation(Unit.class);
    if (help == null || (number && (range == null || unit == null))) {
      throw new IllegalStateException(
          component.getDeclaringRecord().getName()
              + "."
              + name
              + " needs @Help"
              + (number ? ", @Range and @Unit" : ""));
    }
    List<String> choices = new ArrayList<>();
    if (type.isEnum()) {
      for (Object constant : type.getEnumConstants()) {
        choices.add(Parameter.text(constant));
      }
    }
    return new Parameter(
        name,
        type,
        unit == null ? "" : unit.value(),
        number ? range.min() : Double.NEGATIVE_INFINITY,
        number ? range.max() : Double.POSITIVE_INFINITY,
        number && range.logarithmic(),
        help.value(),
        value,
        List.copyOf(choices),
        help.label());
  }
}
