package haltere.ui.viewer;

import haltere.ui.overlay.JavaFxOverlayCanvas;
import haltere.ui.space.BodyFlight;
import haltere.ui.space.BodyFlightDrawing;
import haltere.ui.space.SpaceView;
import java.util.Locale;
import javafx.scene.canvas.Canvas;
import javafx.scene.control.Label;
import javafx.scene.control.Slider;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.Pane;
import javafx.scene.layout.VBox;
import javafx.scene.paint.Color;

/**
 * A body in space and the cameras that see it, at a time that a slider chooses. Dragging turns the
 * view, the wheel comes nearer.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class BodyFlightPane extends BorderPane {
  private static final double RADIANS_PER_PIXEL = 0.01;

  private final BodyFlight flight;
  private final BodyFlightDrawing drawing;
  private final SpaceView view = new SpaceView();
  private final Canvas canvas = new Canvas();
  private final JavaFxOverlayCanvas marks = new JavaFxOverlayCanvas(canvas.getGraphicsContext2D());
  private final Slider slider = new Slider();
  private final Label words = new Label();
  private double pressedX;
  private double pressedY;
  private boolean fitted;

  BodyFlightPane(BodyFlight flight) {
    this.flight = flight;
    drawing = new BodyFlightDrawing(flight);
    Pane holder = new Pane(canvas);
    canvas.widthProperty().bind(holder.widthProperty());
    canvas.heightProperty().bind(holder.heightProperty());
    canvas.widthProperty().addListener((property, was, is) -> fit());
    canvas.heightProperty().addListener((property, was, is) -> fit());
    holder.setMinSize(0, 0);
    setCenter(holder);
    slider.setId("flight-time");
    slider.setAccessibleText("Time of the flight");
    canvas.setAccessibleText("The body and the cameras in space");
    slider.setMax(Math.max(0, flight.moments().size() - 1));
    slider.valueProperty().addListener((property, was, is) -> redraw());
    words.setId("flight-words");
    VBox controls = new VBox(4, slider, words);
    controls.getStyleClass().add("flight-controls");
    setBottom(controls);
    canvas.setOnMousePressed(
        event -> {
          pressedX = event.getX();
          pressedY = event.getY();
        });
    canvas.setOnMouseDragged(
        event -> {
          view.turn(
              RADIANS_PER_PIXEL * (pressedX - event.getX()),
              RADIANS_PER_PIXEL * (event.getY() - pressedY));
          pressedX = event.getX();
          pressedY = event.getY();
          redraw();
        });
    canvas.setOnScroll(
        event -> {
          view.zoom(Math.exp(event.getDeltaY() * 0.002));
          redraw();
        });
  }

  private void fit() {
    if (!fitted && canvas.getWidth() > 0 && canvas.getHeight() > 0) {
      view.fit(drawing.points(), canvas.getWidth(), canvas.getHeight());
      fitted = canvas.getWidth() > 100 && canvas.getHeight() > 100;
    }
    redraw();
  }

  private void redraw() {
    var graphics = canvas.getGraphicsContext2D();
    graphics.setFill(Color.rgb(20, 22, 26));
    graphics.fillRect(0, 0, canvas.getWidth(), canvas.getHeight());
    marks.setView(1, 0, canvas.getHeight());
    int index = (int) Math.round(slider.getValue());
    drawing.draw(index, view, marks);
    words.setText(index < flight.moments().size() ? words(index) : "no orientation was found");
  }

  private String words(int index) {
    var now = flight.moments().get(index).estimate();
    return String.format(
        Locale.ROOT,
        "%.3f s   axis (%.2f, %.2f, %.2f) \u00b1 %.1f\u00b0   head %.0f %%   used %d, rejected %d",
        now.timeUs() * 1e-6,
        now.ux(),
        now.uy(),
        now.uz(),
        Math.toDegrees(now.sdAxisRad()),
        100 * now.headProbability(),
        now.used(),
        now.rejected());
  }
}
