package haltere.core.format.internal.decoding;

import haltere.core.format.Violation;
import haltere.core.format.internal.clock.EventTimes;

/** What it means that an event is before the one before it. */
public final class StepBack {
  private StepBack() {}

  /**
   * The violation to count.
   *
   * @param times which have just held the event back
   * @return whether the event is late or the clock was restarted
   */
  public static Violation kind(EventTimes times) {
    return times.isLate() ? Violation.OUT_OF_ORDER : Violation.CLOCK_WENT_BACK;
  }
}
