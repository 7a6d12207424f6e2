package haltere.ui.viewer.playback;

import atlantafx.base.theme.Styles;
import haltere.core.playback.Slicing;
import haltere.ui.viewer.controls.Controls;
import java.util.List;
import javafx.geometry.Pos;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Label;
import javafx.scene.control.TextField;
import javafx.scene.layout.HBox;

/** Division of the stream into slices: 1/120 s, by time, by number of events, or by wing beat. */
final class SlicingField extends HBox {
  private enum Mode {
    SMOOTH("Smooth", "", 0),
    TIME("By time", "\u00b5s", 20_000),
    COUNT("By count", "events", 5_000),
    BEAT("One wing beat", "", 0);

    final String label;
    final String unit;
    final int usual;

    Mode(String label, String unit, int usual) {
      this.label = label;
      this.unit = unit;
      this.usual = usual;
    }
  }

  private final PlaybackController playback;
  private final ChoiceBox<Mode> mode =
      Controls.choice(
          "slicing",
          "Content of one step: 1/120 s at the present speed, a fixed time, a fixed"
              + " number of events, or one beat of the tracked wings.",
          List.of(Mode.values()),
          each -> each.label);
  private final TextField size = Controls.entry("slice-size", "Size of a slice", 6);
  private final Label unit = Controls.label("", Styles.TEXT_MUTED);

  SlicingField(PlaybackController playback) {
    this.playback = playback;
    setAlignment(Pos.CENTER_LEFT);
    setSpacing(6);
    setUpMode();
    Controls.onEntered(size, this::commit);
    Controls.help(size, "A whole number from 1 on; a longer slice has more events");
    showSize();
    playback
        .beatsProperty()
        .subscribe(
            (was, is) -> {
              if (is) {
                mode.setValue(Mode.BEAT);
              } else if (mode.getValue() == Mode.BEAT) {
                mode.setValue(Mode.SMOOTH);
              }
            });
    getChildren().addAll(mode, size, unit);
  }

  private void setUpMode() {
    mode.setAccessibleText("Slices");
    mode.setValue(Mode.SMOOTH);
    mode.valueProperty()
        .subscribe(
            (old, now) -> {
              size.setText(Integer.toString(now.usual));
              showSize();
              if (now == Mode.BEAT) {
                playback.beatsProperty().set(true);
              } else {
                commit();
              }
            });
  }

  private void showSize() {
    boolean sized = mode.getValue().usual > 0;
    Controls.show(sized, size, unit);
    unit.setText(mode.getValue().unit);
  }

  private void commit() {
    Slicing wanted;
    try {
      wanted =
          switch (mode.getValue()) {
            case SMOOTH -> PlaybackController.SMOOTH;
            case TIME -> new Slicing.ByTime(Long.parseLong(size.getText().strip()));
            case BEAT -> playback.slicingProperty().get();
            case COUNT -> new Slicing.ByCount(Integer.parseInt(size.getText().strip()));
          };
    } catch (IllegalArgumentException notASize) {
      size.pseudoClassStateChanged(Styles.STATE_DANGER, true);
      return;
    }
    size.pseudoClassStateChanged(Styles.STATE_DANGER, false);
    if (!wanted.equals(playback.slicingProperty().get())) {
      playback.setSlicing(wanted);
    }
  }
}
