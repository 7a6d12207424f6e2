package haltere.core.chain;

import haltere.core.extension.Extensions;
import haltere.core.settings.SettingsProblem;
import haltere.core.stream.internal.MachineFault;
import java.util.Collections;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * The available filters, found as services on the class path and the module path.
 *
 * <p>Thread rule: all methods may be called from any thread.
 *
 * @since 0.1
 */
public final class Filters {
  private static final Pattern NAME = Pattern.compile("[a-z0-9]+(-[a-z0-9]+)*");

  private Filters() {}

  /**
   * All providers.
   *
   * @return by name, in alphabetical order
   */
  public static Map<String, FilterProvider<?>> all() {
    Map<String, FilterProvider<?>> found = new TreeMap<>();
    for (FilterProvider<?> provider : Extensions.find(FilterProvider.class)) {
      fault(provider, found)
          .ifPresentOrElse(
              fault -> Extensions.problem(provider.getClass().getName() + " is left out: " + fault),
              () -> found.put(provider.name(), provider));
    }
    return Collections.unmodifiableMap(found);
  }

  /** The reason why a filter cannot be used; those of the library are tested. */
  private static Optional<String> fault(
      FilterProvider<?> provider, Map<String, FilterProvider<?>> found) {
    if (found.containsKey(provider.name())) {
      return Optional.of("another filter is named " + provider.name() + " too");
    }
    if (Extensions.isForeign(provider)) {
      if (!NAME.matcher(provider.name()).matches()) {
        return Optional.of(
            "its name \"" + provider.name() + "\" is not lower case words joined by hyphens");
      }
      try {
        provider.schema();
      } catch (RuntimeException | LinkageError wrong) {
        return Optional.of(wrong.getMessage());
      }
    }
    return Optional.empty();
  }

  /**
   * The provider of a name.
   *
   * @param name such as {@code refractory}
   * @return its provider
   * @throws ChainProblem if there is none, listing the names that there are
   */
  public static FilterProvider<?> named(String name) {
    FilterProvider<?> provider = all().get(Objects.requireNonNull(name, "name"));
    if (provider == null) {
      throw new ChainProblem(
          "there is no filter named "
              + name
              + "; there are "
              + all().keySet().stream().collect(Collectors.joining(", ")));
    }
    return provider;
  }

  /**
   * Creates a filter; an exception or error of its constructor becomes a problem that names the
   * filter.
   *
   * @param provider of the filter
   * @param constructor creates it
   */
  static EventFilter create(
      FilterProvider<?> provider, Supplier<? extends EventFilter> constructor) {
    try {
      return constructor.get();
    } catch (ChainProblem | SettingsProblem problem) {
      throw problem;
    } catch (RuntimeException | Error thrown) {
      MachineFault.rethrow(thrown);
      String line = "the filter " + provider.name() + " cannot be created: " + thrown;
      throw (ChainProblem) new ChainProblem(line).initCause(thrown);
    }
  }
}
