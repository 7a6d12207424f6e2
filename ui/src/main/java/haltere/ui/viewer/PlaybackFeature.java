package haltere.ui.viewer;

import haltere.core.playback.Loop;
import haltere.ui.viewer.action.ViewerActions;
import haltere.ui.viewer.controls.Texts;
import haltere.ui.viewer.controls.Windows;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;
import haltere.ui.viewer.playback.PlaybackController;
import javafx.beans.binding.BooleanExpression;

/** The actions of playback and their keys. */
final class PlaybackFeature implements ViewerFeature {
  private static final long JUMP_US = 1_000_000;
  private static final int JOG_SLICES = 20;

  private ViewerActions actions;
  private PlaybackController playback;

  @Override
  public void install(ViewerContext window) {
    actions = window.actions();
    playback = window.playback();
    add("play-pause", playback::togglePause);
    actions.add(
        "play-backwards", playback.reverseProperty(), playback::toggleReverse, this::seekProblem);
    add("step-on", () -> playback.step(1));
    add("step-off", () -> playback.step(-1));
    add("jog-on", () -> playback.step(JOG_SLICES));
    add("jog-off", () -> playback.step(-JOG_SLICES));
    actions.add("go-faster", playback::faster, this::noSpeed);
    actions.add("go-slower", playback::slower, this::noSpeed);
    actions.add("real-time", () -> playback.setSpeed(1), this::noSpeed);
    actions.add("slow-motion", () -> playback.setSpeed(1e-3), this::noSpeed);
    add("to-start", playback::rewind);
    add("to-first", () -> playback.seek(0));
    add("to-last", () -> playback.seek(Long.MAX_VALUE));
    add("jump-on", () -> playback.jump(JUMP_US));
    add("jump-back", () -> playback.jump(-JUMP_US));
    add("leap-on", () -> playback.jump(10 * JUMP_US));
    add("leap-back", () -> playback.jump(-10 * JUMP_US));
    add("loop-start", playback::markIn);
    add("loop-end", playback::markOut);
    actions.add("clear-in-out", playback::clearInOut, this::noLoopEnds);
    actions.add(
        "repeat",
        BooleanExpression.booleanExpression(playback.loopProperty().map(Loop::on)),
        () -> playback.setLooping(!playback.loopProperty().get().on()),
        () -> "");
    add("set-mark", playback::mark);
    add(
        "name-mark",
        () -> Windows.ask(window.stage(), "Mark", "Name of the mark here", "", playback::mark));
    actions.add("jump-to-time", () -> askForTime(window), this::seekProblem);
    actions.add("mark-before", () -> playback.toMark(false), this::noMarks);
    actions.add("mark-after", () -> playback.toMark(true), this::noMarks);
    actions.add("clear-marks", playback::clearMarks, this::noMarks);
    add("reset-filters", playback::reset);
  }

  private String seekProblem() {
    return playback.reach().isEmpty() ? "nothing to go back to is open" : "";
  }

  private String noSpeed() {
    return playback.isLive() ? "a camera plays in real time" : "";
  }

  private String noMarks() {
    return playback.marks().isEmpty() ? "there are no marks" : "";
  }

  private String noLoopEnds() {
    Loop loop = playback.loopProperty().get();
    return loop.inUs().isEmpty() && loop.outUs().isEmpty() ? "no part is marked" : "";
  }

  private void askForTime(ViewerContext window) {
    String here = playback.status().map(now -> Texts.time(now.elapsedUs(), true)).orElse("");
    Windows.ask(
        window.stage(),
        "Jump",
        "Time, as 1:02.345 or 250 ms",
        here,
        text -> {
          String refusal = text + " is not a time such as 1:02.345 or 250 ms";
          Texts.parseTime(text)
              .ifPresentOrElse(
                  us -> jump(window, text, us), () -> window.status().showRefusal(refusal));
        });
  }

  private void jump(ViewerContext window, String text, long us) {
    playback
        .reach()
        .filter(span -> us < span.fromUs() || us >= span.toUs())
        .ifPresentOrElse(
            span -> {
              String first = Texts.time(span.fromUs(), true);
              String range = first + " to " + Texts.time(span.toUs(), true);
              window.status().showRefusal(text + " is outside of what can be shown, " + range);
            },
            () -> playback.seek(us));
  }

  private void add(String id, Runnable work) {
    actions.add(id, work, () -> playback.status().isEmpty() ? "nothing is open" : "");
  }
}
