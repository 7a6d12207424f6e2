package haltere.ui.viewer.space;

import haltere.core.chain.FilterChain;
import haltere.core.event.SensorGeometry;
import haltere.core.overlay.OverlayCanvas;
import haltere.core.playback.Playable;
import haltere.ui.space.BodyFlight;
import haltere.ui.space.BodyFlightDrawing;
import haltere.ui.space.CameraLine;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.Theme;
import haltere.ui.viewer.picture.DisplayOptions;
import haltere.ui.viewer.picture.DisplaySink;
import haltere.ui.viewer.picture.EventView;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Executor;
import javafx.beans.property.BooleanProperty;
import javafx.geometry.Orientation;
import javafx.scene.control.CheckBox;
import javafx.scene.control.Label;
import javafx.scene.control.SplitPane;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.ColumnConstraints;
import javafx.scene.layout.GridPane;
import javafx.scene.layout.Priority;
import javafx.scene.layout.VBox;

/**
 * A body in space and the cameras at the present time, and the pictures of all cameras but the
 * first (shown by the main window), with the body's line.
 */
final class LiveFlightPane extends BorderPane {
  private static final String NOTHING = "Open a flight before several cameras, in the File menu.";

  private final BooleanProperty linesShown;
  private final SpaceCanvas canvas = new SpaceCanvas();
  private final GridPane pictures = new GridPane(2, 2);
  private final SplitPane both = new SplitPane(canvas);
  private final Label text = Controls.named(Controls.paragraph(NOTHING), "live-flight-words");
  private final List<EventView> views = new ArrayList<>();
  private final List<DisplaySink> sinks = new ArrayList<>();
  private List<CameraLine> lines = List.of();

  /** Nothing is open; lines are drawn over the pictures while they are shown. */
  LiveFlightPane(BooleanProperty linesShown) {
    this.linesShown = linesShown;
    linesShown.subscribe(() -> views.forEach(EventView::redraw));
    setId("live-flight");
    pictures.setMinSize(0, 0);
    both.setOrientation(Orientation.VERTICAL);
    setCenter(both);
    CheckBox shown = Controls.named(new CheckBox("Lines over the pictures"), "camera-lines");
    shown.selectedProperty().bindBidirectional(linesShown);
    Controls.help(
        shown, "Accepted lines are green, gated ones red and broken, the estimated axis white.");
    VBox controls = new VBox(4, shown, text);
    controls.getStyleClass().addAll("flight-controls");
    setBottom(controls);
  }

  /**
   * Shows the last moment of a flight, null if it is the one that is shown, and the newest
   * pictures. True if lines have to be drawn again over a picture that came first.
   */
  boolean update(BodyFlight flight, Executor processing) {
    if (flight != null) {
      int last = flight.moments().size() - 1;
      canvas.show(new BodyFlightDrawing(flight), Math.max(0, last));
      text.setText(last < 0 ? "no orientation yet" : SpaceCanvas.label(flight.moments().get(last)));
      lines = last < 0 ? List.of() : flight.moments().get(last).lines();
      views.forEach(EventView::redraw);
    }
    for (int i = 0; i < views.size(); i++) {
      views.get(i).show(sinks.get(i), processing);
    }
    return flight != null;
  }

  /** Draws the newest line of a camera, counted from 0, while lines are shown. */
  void drawLine(int camera, OverlayCanvas over) {
    if (linesShown.get() && camera < lines.size()) {
      lines.get(camera).draw(over);
    }
  }

  /** Something else is open. */
  void clear() {
    canvas.clear();
    clearPictures();
    both.getItems().setAll(canvas);
    text.setText(NOTHING);
  }

  private void clearPictures() {
    pictures.getChildren().clear();
    pictures.getColumnConstraints().clear();
    views.clear();
    sinks.clear();
    lines = List.of();
  }

  /** Switches to other cameras; returns the sinks of their events. */
  List<DisplaySink> reset(List<Playable> cameras, DisplayOptions options) {
    canvas.goBack();
    clearPictures();
    both.getItems().setAll(canvas, pictures);
    both.setDividerPositions(0.55);
    text.setText("no orientation yet");
    int columns = (int) Math.ceil(Math.sqrt(cameras.size()));
    for (int i = 0; i < cameras.size(); i++) {
      int camera = i + 1;
      SensorGeometry geometry = cameras.get(i).geometry();
      EventView view = Controls.named(new EventView(), "camera-picture-" + camera);
      view.setAccessibleText("Events of camera " + (camera + 1));
      // as narrow as its column, so that no label is cut off
      view.setMinSize(0, 0);
      view.setGeometry(geometry, options.colours());
      view.addLayer(over -> drawLine(camera, over));
      views.add(view);
      sinks.add(DisplaySink.direct(geometry, new FilterChain(geometry), options));
      GridPane.setVgrow(view, Priority.ALWAYS);
      pictures.add(view, i % columns, i / columns);
    }
    for (int i = 0; i < columns; i++) {
      ColumnConstraints column = new ColumnConstraints();
      column.setPercentWidth(100.0 / columns);
      pictures.getColumnConstraints().add(column);
    }
    return List.copyOf(sinks);
  }

  /** Shows events in another way. */
  void setOptions(DisplayOptions options) {
    sinks.forEach(sink -> sink.renderer().setOptions(options));
  }

  void setTheme(Theme theme) {
    canvas.setTheme(theme);
  }
}
