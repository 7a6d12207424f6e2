package haltere.core.simulation;

import haltere.core.extension.Extensions;
import java.util.Collections;
import java.util.Map;
import java.util.TreeMap;

/**
 * The available scenes, found as services on the class path and the module path.
 *
 * <p>Thread rule: all methods may be called from any thread.
 *
 * @since 0.1
 */
public final class Scenes {
  private Scenes() {}

  /**
   * All providers.
   *
   * @return by name, in alphabetical order
   */
  public static Map<String, SceneProvider<?>> all() {
    Map<String, SceneProvider<?>> found = new TreeMap<>();
    for (SceneProvider<?> provider : Extensions.find(SceneProvider.class)) {
      SceneProvider<?> other = found.putIfAbsent(provider.name(), provider);
      if (other != null) {
        Extensions.problem(
            "two scenes are named "
                + provider.name()
                + "; "
                + provider.getClass().getName()
                + " is left out");
      }
    }
    return Collections.unmodifiableMap(found);
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
