package haltere.filters.cluster;

import java.util.ArrayDeque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * The last results of each identity, oldest first. Thread rule: that of its owner.
 *
 * @param <T> a result
 */
public final class Paths<T> {
  private final Map<Integer, ArrayDeque<T>> paths = new HashMap<>();

  /** No path yet. */
  public Paths() {
    // the field is enough
  }

  /**
   * Adds a result.
   *
   * @param id whose it is
   * @param result the latest of that identity
   * @param maxLength largest length of a path, at least 1
   * @return a copy of the path, which ends with the result
   */
  public List<T> add(int id, T result, int maxLength) {
    ArrayDeque<T> path = paths.computeIfAbsent(id, key -> new ArrayDeque<>());
    path.add(result);
    while (path.size() > maxLength) {
      path.removeFirst();
    }
    return List.copyOf(path);
  }

  /**
   * Forgets all paths but some.
   *
   * @param ids identities whose paths are kept
   */
  public void keep(Set<Integer> ids) {
    paths.keySet().retainAll(ids);
  }
}
