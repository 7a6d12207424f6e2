package haltere.ui.viewer.file;

import haltere.core.event.Frame;
import haltere.core.playback.Mark;
import haltere.core.playback.Playable;
import haltere.core.playback.PlayerStatus;
import haltere.core.stream.StreamHandler;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.feature.DisplayControl;
import haltere.ui.viewer.feature.UserSettings;
import haltere.ui.viewer.feature.ViewerPanels;
import haltere.ui.viewer.feature.WindowFeature;
import haltere.ui.viewer.session.RecordingFacts;
import haltere.ui.viewer.session.SessionRequest;
import haltere.ui.viewer.session.ViewerSession;
import java.io.IOException;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Collectors;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.geometry.Pos;
import javafx.scene.control.Label;

/**
 * Samples of a recording: frames below the events, also after a jump; triggers as ticks on the time
 * bar, and as text over the picture unless they are the camera's own frame timing.
 */
public final class SamplesFeature extends WindowFeature {
  /** Maximum age in slices of a named signal: 100 ms of smooth playback. */
  private static final int NAMED_SLICES = 12;

  private static final int MAX_NAMES = 3;

  private final BooleanProperty hasFrames = new SimpleBooleanProperty();
  private final Label trigger = Controls.named(new Label(), "trigger-mark", "readout");
  private boolean reading;

  @Override
  protected void install() {
    DisplayControl display = window.display();
    ViewerPanels panels = window.panels();
    UserSettings settings = window.settings();
    panels.viewBar().addFrames(display.framesProperty(), display.frameOpacityProperty(), hasFrames);
    settings.keep("frames", display.framesProperty());
    settings.keep(
        "frameOpacity",
        display.frameOpacityProperty(),
        value -> value.doubleValue(),
        kept -> Math.max(0.1, Math.min(1, ((Number) kept).doubleValue())));
    window
        .actions()
        .add(
            "show-frames",
            display.framesProperty(),
            () -> hasFrames.get() ? "" : "there are no frames");
    trigger.setMouseTransparent(true);
    trigger.setVisible(false);
    panels.addOverPicture(trigger, Pos.TOP_RIGHT);
    window.sessions().factsProperty().subscribe((was, is) -> follow(is));
    panels.onPulse(() -> window.ifOpen(this::pulse));
  }

  private void follow(Optional<RecordingFacts> facts) {
    hasFrames.set(facts.filter(found -> !found.frames().isEmpty()).isPresent());
    window.panels().seekBar().setTicks(facts.map(RecordingFacts::triggers).orElse(List.of()));
    facts.ifPresent(found -> window.ifOpen(open -> open.display().useFrameBits(found.usedBits())));
  }

  private void pulse(ViewerSession open) {
    Optional<RecordingFacts> facts = window.sessions().factsProperty().get();
    if (facts.isEmpty()) {
      trigger.setVisible(false);
      return;
    }
    PlayerStatus now = open.player().status();
    long shownUs = now.elapsedUs() + now.sliceUs();
    name(facts.get().signals(), shownUs, NAMED_SLICES * Math.max(1, now.sliceUs()));
    int frame = lastAt(facts.get().frames(), shownUs);
    if (!reading && frame >= 0 && open.display().renderer().frames().isFrameRequested()) {
      read(open, facts.get(), facts.get().frames().get(frame));
    }
  }

  private void name(List<Mark> signals, long shownUs, long spanUs) {
    int before = lastAt(signals, shownUs - spanUs + 1);
    String text =
        signals.subList(before + 1, lastAt(signals, shownUs) + 1).stream()
            .map(Mark::name)
            .distinct()
            .sorted()
            .limit(MAX_NAMES)
            .collect(Collectors.joining(", "));
    trigger.setText(text);
    trigger.setVisible(!text.isEmpty());
  }

  /** Index of the last moment before an elapsed time, -1 without one. */
  private static int lastAt(List<Mark> moments, long elapsedUs) {
    // an unnamed mark sorts before all others of its time
    return -2 - Collections.binarySearch(moments, new Mark("", Math.max(0, elapsedUs)));
  }

  private void read(ViewerSession open, RecordingFacts of, Mark frame) {
    reading = true;
    window.file(
        () -> frameAt(of, open, frame.elapsedUs()),
        found -> {
          reading = false;
          found.ifPresent(open.display()::giveFrame);
        },
        problem -> {
          reading = false;
          window.status().showProblem(problem);
        });
  }

  private static Optional<Frame> frameAt(RecordingFacts of, ViewerSession open, long elapsedUs)
      throws IOException {
    try (Playable own = SessionRequest.play(of.file(), open.request().options())) {
      own.seek(elapsedUs);
      AtomicReference<Frame> found = new AtomicReference<>();
      StreamHandler consumer =
          StreamHandler.ofSamples(
              sample -> {
                if (sample instanceof Frame first) {
                  found.compareAndSet(null, first);
                }
              });
      while (found.get() == null && !Thread.currentThread().isInterrupted() && own.next(consumer)) {
        // up to the first frame
      }
      return Optional.ofNullable(found.get());
    }
  }
}
