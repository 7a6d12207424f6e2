package haltere.ui.viewer.wings;

import haltere.filters.wing.WingTrackerState;
import haltere.ui.command.terminal.Quantities;
import java.util.List;

/** Describes the state of a wing tracker and the steps of its search. */
final class SearchText {
  private SearchText() {}

  /** A line for its present state, then one for each step of its last search. */
  static String of(WingsView now) {
    List<WingTrackerState> steps = now.steps();
    StringBuilder text =
        new StringBuilder(now.status().isEmpty() ? "Tracks both wings." : now.status());
    for (WingTrackerState step : steps.subList(0, Math.max(0, steps.size() - 1))) {
      text.append('\n').append(step(step));
    }
    return text.toString();
  }

  private static String step(WingTrackerState s) {
    return switch (s.phase()) {
      case TWO_MEANS ->
          Quantities.text(
              "1. Two classes of %,d events, %.0f px apart about %.1f, %.1f",
              s.events(), s.sizePx(), s.centreX(), s.centreY());
      case BEAT ->
          Quantities.text(
              "2. Beat %.1f Hz, body axis %d\u00b0",
              s.frequencyHz(), Math.floorMod(Math.round(Math.toDegrees(s.headingRad())), 180));
      case HINGES ->
          Quantities.text(
              "3. Hinges about %.1f, %.1f; beat %.1f Hz, reach %.0f px",
              s.centreX(), s.centreY(), s.frequencyHz(), s.sizePx());
      default ->
          Quantities.text(
              "4. Heading %.0f\u00b0, probability %.0f %%",
              Math.toDegrees(s.headingRad()), 100 * s.confidence());
    };
  }
}
