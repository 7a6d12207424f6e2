package haltere.ui.viewer.saving;

import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.Icons;
import haltere.ui.viewer.controls.Texts;
import haltere.ui.viewer.feature.BackgroundWork;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import javafx.geometry.Pos;
import javafx.scene.control.Label;
import javafx.scene.control.ToggleButton;
import javafx.scene.layout.HBox;

/** Records the events that the chain passes, and shows duration and size of the file. */
final class RecordButton extends HBox {
  /** Update interval of the numbers. */
  static final long NUMBERS_NANOS = 500_000_000;

  private final ToggleButton button =
      Controls.toggle(
          "record-button",
          Icons.RECORD,
          "Record the events that the chain passes (Ctrl+E)",
          "record-button");
  private final Label numbers = Controls.named(new Label(), "record-numbers", "time");
  private final BackgroundWork background;
  private long startNanos;

  /**
   * The button of a recording, which starts and stops it and reads the size of the file in the
   * background.
   */
  RecordButton(Runnable toggle, BackgroundWork background) {
    this.background = background;
    setAlignment(Pos.CENTER_LEFT);
    button.setOnAction(
        event -> {
          button.setSelected(!button.isSelected());
          toggle.run();
        });
    getChildren().addAll(button, numbers);
    setOn(false);
  }

  /** Shows whether a recording is under way. */
  void setOn(boolean on) {
    button.setSelected(on);
    startNanos = System.nanoTime();
    numbers.setText("");
    Controls.show(on, numbers);
  }

  /** Shows the duration of the recording and the size of its file. */
  void pulse(Optional<Path> file) {
    if (!button.isSelected() || file.isEmpty()) {
      return;
    }
    Path written = file.get();
    String elapsed = Texts.time((System.nanoTime() - startNanos) / 1000, false);
    background.file(
        () -> Files.exists(written) ? Files.size(written) : 0L,
        bytes -> numbers.setText(elapsed + "  " + Texts.quantity(bytes) + "B"),
        problem -> numbers.setText(elapsed));
  }
}
