package haltere.ui.viewer.space;

import haltere.ui.space.BodyFlight;
import haltere.ui.space.BodyFlightDrawing;
import haltere.ui.viewer.controls.Theme;
import javafx.scene.control.Label;
import javafx.scene.layout.BorderPane;

/**
 * A body in space and the cameras that see it, now.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class LiveFlightPane extends BorderPane {
  private static final String NOTHING = "Open a flight before several cameras, in the File menu.";

  private final SpaceCanvas canvas = new SpaceCanvas();
  private final Label words = new Label(NOTHING);

  LiveFlightPane() {
    setId("live-flight");
    setCenter(canvas);
    words.setId("live-flight-words");
    words.setWrapText(true);
    words.setMinHeight(USE_PREF_SIZE);
    words.getStyleClass().add("flight-controls");
    setBottom(words);
  }

  /** Shows the last moment of a flight; null if it is the one that is shown. */
  void update(BodyFlight flight) {
    if (flight != null) {
      int last = flight.moments().size() - 1;
      canvas.show(new BodyFlightDrawing(flight), Math.max(0, last));
      words.setText(
          last < 0 ? "no orientation yet" : SpaceCanvas.words(flight.moments().get(last)));
    }
  }

  /** Something else is open. */
  void clear() {
    canvas.clear();
    words.setText(NOTHING);
  }

  /** Begins with other cameras. */
  void startAnew() {
    canvas.lookAnew();
    words.setText("no orientation yet");
  }

  /** Draws as a theme wants it. */
  void setTheme(Theme theme) {
    canvas.setTheme(theme);
  }
}
