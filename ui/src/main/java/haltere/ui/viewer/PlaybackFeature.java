package haltere.ui.viewer;

import haltere.core.playback.Loop;
import haltere.ui.viewer.action.ViewerAction;
import haltere.ui.viewer.action.ViewerActions;
import haltere.ui.viewer.controls.Questions;
import haltere.ui.viewer.controls.Texts;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;
import haltere.ui.viewer.playback.PlaybackController;
import java.util.OptionalLong;
import java.util.function.Supplier;
import javafx.beans.binding.Bindings;

/** The transport's actions and their keys. */
final class PlaybackFeature implements ViewerFeature {
  private static final String MENU = "Playback";
  private static final long JUMP_US = 1_000_000;
  private static final int JOG_SLICES = 20;

  private ViewerActions actions;
  private PlaybackController playback;

  @Override
  public void install(ViewerContext window) {
    actions = window.actions();
    playback = window.playback();
    add("play-pause", "Play or pause", "Space", playback::togglePause);
    actions.add(
        ViewerAction.toggle(
                "play-backwards",
                "Play backwards",
                MENU,
                playback.reverseProperty(),
                on -> playback.toggleReverse())
            .withKey("Shift+Space")
            .unless(this::noWayBack));
    add("step-on", "One slice on", "Period", () -> playback.step(1));
    add("step-off", "One slice back", "Comma", () -> playback.step(-1));
    add("jog-on", "20 slices on", "Shift+Period", () -> playback.step(JOG_SLICES));
    add("jog-off", "20 slices back", "Shift+Comma", () -> playback.step(-JOG_SLICES));
    actions.beginGroup();
    add("go-faster", "Next higher speed", "F", playback::faster);
    add("go-slower", "Next lower speed", "S", playback::slower);
    add("real-time", "Real time", "1", () -> playback.setSpeed(1));
    add("slow-motion", "Slow motion, a thousandth", "2", () -> playback.setSpeed(1e-3));
    actions.beginGroup();
    add("to-start", "Back to the start", "R", playback::rewind);
    add("to-first", "To the first event", "Home", () -> playback.seek(0));
    add("to-last", "To the end", "End", () -> playback.seek(Long.MAX_VALUE));
    add("jump-on", "One second on", "Right", () -> playback.jump(JUMP_US));
    add("jump-back", "One second back", "Left", () -> playback.jump(-JUMP_US));
    add("leap-on", "Ten seconds on", "Shift+Right", () -> playback.jump(10 * JUMP_US));
    add("leap-back", "Ten seconds back", "Shift+Left", () -> playback.jump(-10 * JUMP_US));
    actions.beginGroup();
    add("loop-start", "Start the loop here", "I", playback::markIn);
    add("loop-end", "End the loop here", "O", playback::markOut);
    add(
        "clear-in-out",
        "Clear the loop's start and end",
        "",
        playback::clearInOut,
        this::noLoopEnds);
    actions.add(
        ViewerAction.toggle(
                "repeat",
                "Repeat at the end",
                MENU,
                Bindings.createBooleanBinding(
                    () -> playback.loopProperty().get().on(), playback.loopProperty()),
                playback::setLooping)
            .withKey("L"));
    actions.beginGroup();
    add("set-mark", "Set a mark", "M", playback::mark);
    add(
        "name-mark",
        "Set a mark with a name\u2026",
        "Shift+M",
        () -> Questions.ask(window.stage(), "Mark", "Name of the mark here", "", playback::mark));
    add(
        "jump-to-time",
        "Jump to a time\u2026",
        "Shortcut+J",
        () -> askForTime(window),
        this::noWayBack);
    add("mark-before", "To the mark before", "J", () -> playback.toMark(false), this::noMarks);
    add("mark-after", "To the mark after", "K", () -> playback.toMark(true), this::noMarks);
    add("clear-marks", "Clear all marks", "", playback::clearMarks, this::noMarks);
    actions.beginGroup();
    add("forget", "Let all filters forget", "Z", playback::reset);
    add("menu-reset", "Reset all filters", "Shortcut+R", playback::reset);
  }

  private String noWayBack() {
    return playback.reach().isEmpty() ? "nothing to go back to is open" : "";
  }

  private String noMarks() {
    return playback.marks().isEmpty() ? "there are no marks" : "";
  }

  private String noLoopEnds() {
    Loop loop = playback.loopProperty().get();
    return loop.inUs().isEmpty() && loop.outUs().isEmpty() ? "no part is marked" : "";
  }

  private static void askForTime(ViewerContext window) {
    PlaybackController playback = window.playback();
    String here = playback.status().map(now -> Texts.time(now.elapsedUs(), true)).orElse("");
    Questions.ask(
        window.stage(),
        "Jump",
        "To which time? Minutes and seconds as 1:02.345, or with a unit as 250 ms",
        here,
        words -> {
          OptionalLong us = Texts.parseTime(words);
          us.ifPresent(at -> jump(window, words, at));
          if (us.isEmpty()) {
            window.status().showError(words + " is no time; 1:02.345 or 250 ms are");
          }
        });
  }

  private static void jump(ViewerContext window, String words, long us) {
    PlaybackController playback = window.playback();
    playback
        .reach()
        .filter(span -> us < span.fromUs() || us >= span.toUs())
        .ifPresentOrElse(
            span ->
                window
                    .status()
                    .showError(
                        words
                            + " is outside of what can be shown, "
                            + Texts.time(span.fromUs(), true)
                            + " to "
                            + Texts.time(span.toUs(), true)),
            () -> playback.seek(us));
  }

  private void add(String id, String words, String key, Runnable work) {
    add(id, words, key, work, () -> playback.status().isEmpty() ? "nothing is open" : "");
  }

  private void add(String id, String words, String key, Runnable work, Supplier<String> obstacle) {
    actions.add(ViewerAction.of(id, words, MENU, work).withKey(key).unless(obstacle));
  }
}
