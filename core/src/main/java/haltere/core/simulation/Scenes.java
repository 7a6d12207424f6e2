package haltere.core.simulation;

import java.util.Collections;
import java.util.Map;
import java.util.ServiceLoader;
import java.util.TreeMap;

/**
 * The scenes that there are, found as services on the class path and the module path.
 *
 * <p>Thread rule: all methods may be called from any thread.
 */
public final class Scenes {
  private static final class Found {
    static final Map<String, SceneProvider<?>> BY_NAME = load();

    private static Map<String, SceneProvider<?>> load() {
      Map<String, SceneProvider<?>> found = new TreeMap<>();
      for (SceneProvider<?> provider : ServiceLoader.load(SceneProvider.class)) {
        SceneProvider<?> other = found.putIfAbsent(provider.name(), provider);
        if (other != null && other.getClass() != provider.getClass()) {
          throw new IllegalStateException(
              "two scenes are named "
                  + provider.name()
                  + ": "
                  + other.getClass().getName()
                  + " and "
                  + provider.getClass().getName());
        }
      }
      return Collections.unmodifiableMap(found);
    }
  }

  private Scenes() {}

  /**
   * All providers.
   *
   * @return by name, in alphabetical order
   */
  public static Map<String, SceneProvider<?>> all() {
    return Found.BY_NAME;
  }

  /**
   * The provider of a name.
   *
   * @param name such as {@code fly}
   * @return its provider
   * @throws IllegalArgumentException if there is none, listing the names that there are
   */
  public static SceneProvider<?> named(String name) {
    SceneProvider<?> provider = all().get(name);
    if (provider == null) {
      throw new IllegalArgumentException(
          "there is no scene named " + name + "; there are " + String.join(", ", all().keySet()));
    }
    return provider;
  }
}
