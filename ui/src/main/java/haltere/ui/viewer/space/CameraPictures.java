package haltere.ui.viewer.space;

import haltere.core.chain.FilterChain;
import haltere.core.event.SensorGeometry;
import haltere.core.playback.Playable;
import haltere.ui.space.CameraLine;
import haltere.ui.space.CameraLineOverlay;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.picture.DisplayFrame;
import haltere.ui.viewer.picture.DisplayOptions;
import haltere.ui.viewer.picture.DisplaySink;
import haltere.ui.viewer.picture.EventView;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javafx.beans.property.BooleanProperty;
import javafx.scene.layout.ColumnConstraints;
import javafx.scene.layout.GridPane;
import javafx.scene.layout.Priority;

/**
 * The events of several cameras side by side, with the line of the body over each picture. The
 * wheel zooms and a drag moves each picture, as in the picture of the window.
 *
 * <p>Thread rule: JavaFX thread only, but for the sinks, which are for the processing thread.
 */
final class CameraPictures extends GridPane {
  private static final CameraLineOverlay OVERLAY = new CameraLineOverlay();

  private final BooleanProperty linesShown;
  private final List<EventView> views = new ArrayList<>();
  private final List<DisplaySink> sinks = new ArrayList<>();
  private List<CameraLine> lines = List.of();

  /** No pictures; lines are drawn while they are shown. */
  CameraPictures(BooleanProperty linesShown) {
    this.linesShown = linesShown;
    setHgap(2);
    setVgap(2);
    setMinSize(0, 0);
    linesShown.subscribe(() -> views.forEach(EventView::redraw));
  }

  /** Begins with other cameras; returns what takes the events of each. */
  List<DisplaySink> startAnew(List<Playable> cameras, DisplayOptions options) {
    clear();
    int columns = (int) Math.ceil(Math.sqrt(cameras.size()));
    for (int i = 0; i < cameras.size(); i++) {
      int index = i;
      SensorGeometry geometry = cameras.get(i).geometry();
      EventView view = Controls.named(new EventView(), "camera-picture-" + (i + 1));
      view.setAccessibleText("Events of camera " + (i + 2));
      view.setGeometry(geometry, options.colours());
      view.addLayer(canvas -> line(index).ifPresent(line -> OVERLAY.draw(line, canvas)));
      views.add(view);
      sinks.add(DisplaySink.direct(geometry, new FilterChain(geometry), options));
      GridPane.setVgrow(view, Priority.ALWAYS);
      add(view, i % columns, i / columns);
    }
    for (int i = 0; i < columns; i++) {
      ColumnConstraints column = new ColumnConstraints();
      column.setPercentWidth(100.0 / columns);
      getColumnConstraints().add(column);
    }
    return List.copyOf(sinks);
  }

  private Optional<CameraLine> line(int index) {
    return linesShown.get() && index < lines.size()
        ? Optional.of(lines.get(index))
        : Optional.empty();
  }

  /** Shows no camera. */
  void clear() {
    getChildren().clear();
    getColumnConstraints().clear();
    views.clear();
    sinks.clear();
    lines = List.of();
  }

  /** Shows events in another way. */
  void setOptions(DisplayOptions options) {
    sinks.forEach(sink -> sink.maker().setOptions(options));
  }

  /** The newest line of each camera. */
  void setLines(List<CameraLine> newest) {
    lines = newest;
  }

  /** Shows the newest frame of each camera. */
  void update() {
    for (int i = 0; i < views.size(); i++) {
      DisplayFrame frame = sinks.get(i).maker().exchange().fetch();
      if (frame != null) {
        views.get(i).show(frame);
      }
    }
  }
}
