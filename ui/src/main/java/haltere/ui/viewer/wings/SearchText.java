package haltere.ui.viewer.wings;

import haltere.filters.wing.WingTrackerState;
import java.util.List;
import java.util.Locale;

/** Says in lines what a wing tracker does, and how it has found the fly. */
final class SearchText {
  private SearchText() {}

  /** A line for what it does now, then one for each step of its last search. */
  static String of(List<WingTrackerState> steps) {
    if (steps.isEmpty()) {
      return "Waits for the first event.";
    }
    WingTrackerState now = steps.get(steps.size() - 1);
    StringBuilder text = new StringBuilder(condition(now));
    for (WingTrackerState step : steps.subList(0, steps.size() - 1)) {
      text.append('\n').append(step(step));
    }
    return text.toString();
  }

  private static String condition(WingTrackerState now) {
    return switch (now.phase()) {
      case TRACKING -> "Tracks both wings.";
      case UNLOCKED -> "Follows the events, not at the frequency of the beat.";
      case ONE_WING -> "Tracks one wing, looks for the other.";
      case LOST -> "Has lost the wings, looks for them.";
      default -> "Waits for wings.";
    };
  }

  private static String step(WingTrackerState s) {
    return switch (s.phase()) {
      case TWO_MEANS ->
          String.format(
              Locale.ROOT,
              "1. Two classes of %,d events, %.0f px apart about %.1f, %.1f",
              s.events(),
              s.sizePx(),
              s.centreX(),
              s.centreY());
      case BEAT ->
          String.format(
              Locale.ROOT,
              "2. Beat %.1f Hz, body axis %d\u00b0",
              s.frequencyHz(),
              Math.floorMod(Math.round(Math.toDegrees(s.headingRad())), 180));
      case HINGES ->
          String.format(
              Locale.ROOT,
              "3. Hinges about %.1f, %.1f; beat %.1f Hz, reach %.0f px",
              s.centreX(),
              s.centreY(),
              s.frequencyHz(),
              s.sizePx());
      default ->
          String.format(
              Locale.ROOT,
              "4. Heading %.0f\u00b0, probability %.0f %%",
              Math.toDegrees(s.headingRad()),
              100 * s.confidence());
    };
  }
}
