package haltere.core.settings;

/**
 * The settings of something that has none.
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
