package haltere.core.settings;

/**
 * Empty settings.
 *
 * @since 0.1
 */
public record NoSettings() {
  /**
   * The only value.
   *
   * @return an empty record
   */
  public static NoSettings defaults() {
    return new NoSettings();
  }
}
