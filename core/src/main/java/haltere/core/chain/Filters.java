package haltere.core.chain;

import java.util.Map;
import java.util.ServiceLoader;
import java.util.TreeMap;
import java.util.stream.Collectors;

/**
 * The filters that there are, found as services on the class path and the module path.
 *
 * <p>Thread rule: all methods may be called from any thread.
 */
public final class Filters {
  private static final class Found {
    static final Map<String, FilterProvider<?>> BY_NAME = load();

    private static Map<String, FilterProvider<?>> load() {
      Map<String, FilterProvider<?>> found = new TreeMap<>();
      for (FilterProvider<?> provider : ServiceLoader.load(FilterProvider.class)) {
        FilterProvider<?> other = found.putIfAbsent(provider.name(), provider);
        if (other != null && other.getClass() != provider.getClass()) {
          throw new IllegalStateException(
              "two filters are named "
                  + provider.name()
                  + ": "
                  + other.getClass().getName()
                  + " and "
                  + provider.getClass().getName());
        }
      }
      return java.util.Collections.unmodifiableMap(found);
    }
  }

  private Filters() {}

  /**
   * All providers.
   *
   * @return by name, in alphabetical order
   */
  public static Map<String, FilterProvider<?>> all() {
    return Found.BY_NAME;
  }

  /**
   * The provider of a name.
   *
   * @param name such as {@code refractory}
   * @return its provider
   * @throws ChainProblem if there is none, listing the names that there are
   */
  public static FilterProvider<?> named(String name) {
    FilterProvider<?> provider = all().get(name);
    if (provider == null) {
      throw new ChainProblem(
          "there is no filter named "
              + name
              + "; there are "
              + all().keySet().stream().collect(Collectors.joining(", ")));
    }
    return provider;
  }
}
