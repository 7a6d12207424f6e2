package haltere.ui.viewer;

import haltere.core.json.Json;
import haltere.core.json.JsonProblem;
import haltere.ui.viewer.feature.UserSettings;
import haltere.ui.viewer.session.SessionRequest;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * The chains that a person has changed, each kept for its recording, scene or camera from one start
 * to the next. Of many the ones that were changed last are kept.
 *
 * <p>Thread rule: JavaFX thread only, or the thread that makes the window, before it is made.
 */
final class ChainMemory {
  private static final String NAME = "chains";
  private static final int MAX_CHAINS = 40;

  private final UserSettings settings;

  /** The chains that the settings hold. */
  ChainMemory(UserSettings settings) {
    this.settings = settings;
  }

  /** The chain of its own that something has, as JSON; empty where nobody has changed it. */
  Optional<String> chain(SessionRequest request) {
    return Optional.ofNullable(chains().get(request.chainKey())).map(Json::write);
  }

  /**
   * Keeps a chain.
   *
   * @param json the chain as saved; empty where it is the one to begin with
   */
  void keep(SessionRequest request, Optional<String> json) {
    Map<String, Object> chains = chains();
    if (chains.remove(request.chainKey()) == null && json.isEmpty()) {
      return;
    }
    json.ifPresent(chain -> chains.put(request.chainKey(), parsed(chain)));
    chains.keySet().stream()
        .limit(Math.max(0, chains.size() - MAX_CHAINS))
        .toList()
        .forEach(chains::remove);
    settings.put(NAME, chains);
  }

  private Map<String, Object> chains() {
    Map<String, Object> chains = new LinkedHashMap<>();
    settings
        .get(NAME)
        .filter(Map.class::isInstance)
        .map(kept -> (Map<?, ?>) kept)
        .ifPresent(kept -> kept.forEach((key, chain) -> chains.put(key.toString(), chain)));
    return chains;
  }

  private static Object parsed(String json) {
    try {
      return Json.parse(json, "a chain");
    } catch (JsonProblem impossible) {
      throw new IllegalStateException(impossible);
    }
  }
}
