package haltere.core.settings;

/**
 * A setting that does not exist or a value that it cannot take; the message says which can.
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
