package haltere.core.simulation;

import haltere.core.settings.SettingsProvider;

/**
 * Creates scenes of one kind. Providers are found as services ({@code
 * META-INF/services/haltere.core.simulation.SceneProvider}), so another jar can add one; see {@link
 * Scenes}.
 *
 * @param <S> the settings record
 * @since 0.1
 */
public interface SceneProvider<S extends Record> extends SettingsProvider<S> {
  /**
   * A new scene at its beginning.
   *
   * @param settings valid settings
   * @return a source; the same settings make the same events
   */
  Scene<?> create(S settings);

  /**
   * A new scene from the default settings and some changes.
   *
   * @param assignments texts of the form {@code name=value}
   * @return a source at its beginning
   * @throws haltere.core.settings.SettingsProblem for a name or a value that is not valid
   */
  default Scene<?> create(Iterable<String> assignments) {
    return create(schema().withAssignments(schema().defaults(), assignments));
  }
}
