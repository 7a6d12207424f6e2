package haltere.filters.wing;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.Unit;

/** What the tracker publishes, and which edges it takes. */
public record WingOutputSettings(
    @Help("Estimates are published at this rate of recording time.")
        @Range(min = 1, max = 100_000, logarithmic = true)
        @Unit("Hz")
        double rateHz,
    @Help("Whether events of the left leading edge are taken.") boolean leftLeading,
    @Help("Whether events of the left trailing edge are taken.") boolean leftTrailing,
    @Help("Whether events of the right leading edge are taken.") boolean rightLeading,
    @Help("Whether events of the right trailing edge are taken.") boolean rightTrailing) {
  /**
   * Whether events of an edge are taken.
   *
   * @param edge one of the four edges, not a wing
   * @return true if so
   */
  public boolean takes(WingPart edge) {
    return switch (edge) {
      case LEFT_LEADING -> leftLeading;
      case LEFT_TRAILING -> leftTrailing;
      case RIGHT_LEADING -> rightLeading;
      case RIGHT_TRAILING -> rightTrailing;
      default -> throw new IllegalArgumentException(edge + " is no edge");
    };
  }
}
