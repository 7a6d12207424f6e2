package haltere.filters.wing;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.Unit;

/** Rate of estimates, and the edges whose events are used. */
public record WingOutputSettings(
    @Help("Estimates are published at this rate of recording time.")
        @Range(min = 1, max = 100_000, logarithmic = true)
        @Unit("Hz")
        double rateHz,
    @Help("Uses events of the left leading edge.") boolean leftLeading,
    @Help("Uses events of the left trailing edge.") boolean leftTrailing,
    @Help("Uses events of the right leading edge.") boolean rightLeading,
    @Help("Uses events of the right trailing edge.") boolean rightTrailing) {
  /**
   * Whether events of an edge, or of any edge of a wing, are used.
   *
   * @param part an edge or a wing
   * @return true if so
   */
  public boolean uses(WingPart part) {
    return switch (part) {
      case LEFT_LEADING -> leftLeading;
      case LEFT_TRAILING -> leftTrailing;
      case RIGHT_LEADING -> rightLeading;
      case RIGHT_TRAILING -> rightTrailing;
      case LEFT -> leftLeading || leftTrailing;
      case RIGHT -> rightLeading || rightTrailing;
    };
  }
}
