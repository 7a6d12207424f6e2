package haltere.ui.viewer.space;

import haltere.core.playback.Playable;
import haltere.ui.space.BodyFlight;
import haltere.ui.space.BodyFlightDrawing;
import haltere.ui.space.CameraLine;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.Theme;
import haltere.ui.viewer.picture.DisplayOptions;
import haltere.ui.viewer.picture.DisplaySink;
import java.util.List;
import java.util.Optional;
import javafx.beans.property.BooleanProperty;
import javafx.geometry.Orientation;
import javafx.scene.control.CheckBox;
import javafx.scene.control.Label;
import javafx.scene.control.SplitPane;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.VBox;

/**
 * A body in space and the cameras that see it, now, and the pictures of all cameras but the first,
 * which the window itself shows.
 */
final class LiveFlightPane extends BorderPane {
  private static final String NOTHING = "Open a flight before several cameras, in the File menu.";

  private final SpaceCanvas canvas = new SpaceCanvas();
  private final CameraPictures pictures;
  private final SplitPane both;
  private final Label words = Controls.named(new Label(NOTHING), "live-flight-words");
  private Optional<CameraLine> first = Optional.empty();

  /** Nothing is open; lines are drawn over the pictures while they are shown. */
  LiveFlightPane(BooleanProperty linesShown) {
    setId("live-flight");
    pictures = new CameraPictures(linesShown);
    both = new SplitPane(canvas);
    both.setOrientation(Orientation.VERTICAL);
    setCenter(both);
    CheckBox lines = Controls.named(new CheckBox("Lines over the pictures"), "camera-lines");
    lines.selectedProperty().bindBidirectional(linesShown);
    Controls.help(
        lines, "Accepted lines are green, gated ones red and broken, the estimated axis white.");
    words.setWrapText(true);
    words.setMinHeight(USE_PREF_SIZE);
    VBox controls = new VBox(4, lines, words);
    controls.getStyleClass().addAll("flight-controls");
    setBottom(controls);
  }

  /** Shows the last moment of a flight; null if it is the one that is shown. */
  void update(BodyFlight flight) {
    if (flight != null) {
      int last = flight.moments().size() - 1;
      canvas.show(new BodyFlightDrawing(flight), Math.max(0, last));
      words.setText(
          last < 0 ? "no orientation yet" : SpaceCanvas.words(flight.moments().get(last)));
      List<CameraLine> lines = last < 0 ? List.of() : flight.moments().get(last).lines();
      first = lines.stream().findFirst();
      pictures.setLines(lines.subList(Math.min(1, lines.size()), lines.size()));
    }
    pictures.update();
  }

  /** The newest line of the first camera; empty if there is no orientation. */
  Optional<CameraLine> first() {
    return first;
  }

  /** Something else is open. */
  void clear() {
    canvas.clear();
    pictures.clear();
    both.getItems().setAll(canvas);
    first = Optional.empty();
    words.setText(NOTHING);
  }

  /** Begins with other cameras; returns what takes the events of each. */
  List<DisplaySink> startAnew(List<Playable> cameras, DisplayOptions options) {
    canvas.lookAnew();
    both.getItems().setAll(canvas, pictures);
    both.setDividerPositions(0.55);
    first = Optional.empty();
    words.setText("no orientation yet");
    return pictures.startAnew(cameras, options);
  }

  /** Shows events in another way. */
  void setOptions(DisplayOptions options) {
    pictures.setOptions(options);
  }

  /** Draws as a theme wants it. */
  void setTheme(Theme theme) {
    canvas.setTheme(theme);
  }
}
