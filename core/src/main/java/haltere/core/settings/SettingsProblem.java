package haltere.core.settings;

/**
 * An unknown setting or an invalid value; the message has the valid ones.
 *
 * @since 0.1
 */
public final class SettingsProblem extends IllegalArgumentException {
  private static final long serialVersionUID = 1L;

  /**
   * A problem.
   *
   * @param message names the setting, the value and what would be valid
   */
  public SettingsProblem(String message) {
    super(message);
  }
}
