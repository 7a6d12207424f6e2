package haltere.ui.viewer.space;

import haltere.ui.space.BodyFlight;
import haltere.ui.space.BodyFlightDrawing;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.Theme;
import javafx.scene.control.Label;
import javafx.scene.control.Slider;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.VBox;

/** A body in space and the cameras, at the time of a slider. */
final class BodyFlightPane extends BorderPane {
  private final BodyFlight flight;
  private final BodyFlightDrawing drawing;
  private final SpaceCanvas canvas = new SpaceCanvas();
  private final Slider slider = Controls.named(new Slider(), "flight-time");
  private final Label text = Controls.named(new Label(), "flight-words");

  BodyFlightPane(BodyFlight flight, Theme theme) {
    this.flight = flight;
    drawing = new BodyFlightDrawing(flight);
    canvas.setTheme(theme);
    setCenter(canvas);
    slider.setAccessibleText("Time of the flight");
    slider.setMax(Math.max(0, flight.moments().size() - 1));
    slider.valueProperty().subscribe((was, is) -> show());
    VBox controls = new VBox(4, slider, text);
    controls.getStyleClass().addAll("flight-controls");
    setBottom(controls);
    show();
  }

  private void show() {
    int index = (int) Math.round(slider.getValue());
    canvas.show(drawing, index);
    text.setText(
        index < flight.moments().size()
            ? SpaceCanvas.label(flight.moments().get(index))
            : "no orientation was found");
  }
}
