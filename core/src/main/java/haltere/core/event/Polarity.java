package haltere.core.event;

/** The direction in which the light on a pixel changed. */
public enum Polarity {
  /** The light fell. */
  OFF,
  /** The light rose. */
  ON;

  /**
   * Polarity of a packed address bit.
   *
   * @param on whether the light rose
   * @return {@link #ON} or {@link #OFF}
   */
  public static Polarity of(boolean on) {
    return on ? ON : OFF;
  }
}
