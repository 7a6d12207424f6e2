package haltere.core.settings;

import java.util.List;

/**
 * A settings record that can return a copy with other values.
 *
 * @param <S> the record itself
 * @since 0.1
 */
public interface AdjustableSettings<S extends Record & AdjustableSettings<S>> {
  /**
   * These settings with some values replaced.
   *
   * @param assignments texts of the form {@code name=value}, such as {@code output.rateHz=100}
   * @return new settings
   * @throws SettingsProblem for a name or a value that is not valid
   */
  @SuppressWarnings("unchecked")
  default S with(String... assignments) {
    S present = (S) this;
    return SettingsSchema.of((Class<S>) present.getClass())
        .withAssignments(present, List.of(assignments));
  }
}
