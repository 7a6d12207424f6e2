package haltere.ui.viewer.picture;

import haltere.core.event.SensorGeometry;
import haltere.core.overlay.OverlayCanvas;
import haltere.filters.frequency.PixelRegion;
import haltere.ui.rendering.ColourMap;
import haltere.ui.viewer.controls.ArrowKeys;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.PixelImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.scene.AccessibleRole;
import javafx.scene.Cursor;
import javafx.scene.control.Label;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.ScrollEvent;
import javafx.scene.layout.Region;
import javafx.scene.shape.Rectangle;

/**
 * Shows frames: events as square pixels, marks over them, a description of the pixel under the
 * mouse. The wheel zooms at the mouse, a drag pans, a double click shows the whole sensor. With a
 * tool, arrow keys and Enter replace the mouse.
 */
public final class EventView extends Region implements ArrowKeys {
  private final Viewpoint viewpoint = new Viewpoint(this::requestLayout);
  private final SensorPicture picture = new SensorPicture();
  private final Rectangle frame = new Rectangle();
  private final Label readout = Controls.named(new Label(), "cursor-readout", "readout");
  private final ScaleLegend legend = new ScaleLegend();
  private final ObjectProperty<Optional<PixelRegion>> pointed =
      new SimpleObjectProperty<>(Optional.empty());
  private int pointedX;
  private int pointedY;

  private SensorGeometry geometry = new SensorGeometry(1, 1);
  private double dragX;
  private double dragY;
  private Optional<ViewTool> tool = Optional.empty();
  private final KeyPointer keys = new KeyPointer();

  /** The sink from which a frame has been requested and not received. */
  private Optional<DisplaySink> asked = Optional.empty();

  private final List<Consumer<OverlayCanvas>> layers = new ArrayList<>();
  private final List<Consumer<Optional<ViewTool>>> toolListeners = new ArrayList<>();
  private final List<Consumer<DisplayFrame>> frameListeners = new ArrayList<>();

  /** A view without a frame. */
  public EventView() {
    Controls.named(this, "event-view", "event-view");
    setAccessibleRole(AccessibleRole.IMAGE_VIEW);
    setAccessibleText("Events");
    setFocusTraversable(true);
    setMinSize(160, 120);
    frame.getStyleClass().add("sensor-frame");
    frame.setManaged(false);
    frame.setMouseTransparent(true);
    readout.setMouseTransparent(true);
    readout.setManaged(false);
    readout.setVisible(false);
    readout.setWrapText(true);
    getChildren().add(picture.node());
    getChildren().addAll(frame, readout, legend);
    layoutBoundsProperty().subscribe((was, is) -> viewpoint.setSize(getWidth(), getHeight()));
    Controls.clip(this);
    setOnScroll(this::scrolled);
    setOnMousePressed(this::pressed);
    setOnMouseDragged(this::dragged);
    setOnMouseReleased(this::released);
    setOnMouseClicked(
        event -> {
          if (!worksWithTool(event) && event.getClickCount() == 2) {
            viewpoint.showAll();
          }
        });
    setOnMouseMoved(this::pointed);
    setOnMouseExited(event -> clearPointer());
    setOnKeyPressed(this::keyPressed);
  }

  /** Prepares for frames of another sensor. */
  public void setGeometry(SensorGeometry newGeometry, ColourMap colours) {
    if (!newGeometry.equals(geometry)) {
      geometry = newGeometry;
      picture.setGeometry(geometry, colours);
      viewpoint.setSensor(geometry);
    }
  }

  /**
   * Shows the newest frame of a sink, true if there is one; else requests one on the processing
   * thread, if needed.
   */
  public boolean show(DisplaySink sink, Executor processing) {
    DisplayFrame frame = sink.renderer().exchange().fetch();
    if (frame != null) {
      asked = Optional.empty();
      show(frame);
    } else if (sink.renderer().isStale() && !asked.equals(Optional.of(sink))) {
      asked = Optional.of(sink);
      processing.execute(sink::paint);
    }
    return frame != null;
  }

  /** Shows a frame of the current sensor. */
  public void show(DisplayFrame frame) {
    if (!frame.geometry.equals(geometry)) {
      return;
    }
    picture.setFrame(frame);
    if (readout.isVisible()) {
      frame
          .pixel
          .filter(pixel -> pixel.x() == pointedX && pixel.y() == pointedY)
          .ifPresent(pixel -> showReadout(pixel.label()));
    }
    legend.show(frame.scale);
    frameListeners.forEach(listener -> listener.accept(frame));
    redraw();
  }

  /** Shows or hides the marks. */
  public void setMarksVisible(boolean visible) {
    picture.setMarksVisible(visible);
    requestLayout();
  }

  /**
   * Mapping for frames in screen resolution, drawn by another thread; empty if that is not needed.
   */
  public Optional<ScreenMapping> screenMapping() {
    return picture.screenMapping();
  }

  /** The pixel under the mouse. */
  public ReadOnlyObjectProperty<Optional<PixelRegion>> pointedProperty() {
    return pointed;
  }

  /** Which part of the sensor is seen, and how large. */
  public Viewpoint viewpoint() {
    return viewpoint;
  }

  /** The legend of the colours. */
  public ScaleLegend legend() {
    return legend;
  }

  /** Zooms in to the maximum at the last position of the mouse. */
  public void zoomToPixels() {
    viewpoint.zoomTo(PixelRegion.around(pointedX, pointedY, 4));
  }

  /** Selects a tool, or none, in place of the present one. */
  public void setTool(Optional<ViewTool> newTool) {
    tool.ifPresent(ViewTool::dismiss);
    tool = newTool;
    if (keys.isShown()) {
      keys.end();
      clearPointer();
    }
    if (tool.isPresent()) {
      requestFocus();
    }
    setCursor(tool.isPresent() ? Cursor.CROSSHAIR : Cursor.DEFAULT);
    toolListeners.forEach(listener -> listener.accept(tool));
    redraw();
  }

  /** Adds a listener to the selected tool. */
  public void onToolChange(Consumer<Optional<ViewTool>> listener) {
    toolListeners.add(listener);
  }

  /** Adds a listener to every shown frame, before its marks are drawn. */
  public void onFrame(Consumer<DisplayFrame> listener) {
    frameListeners.add(listener);
  }

  /** The selected tool. */
  public Optional<ViewTool> tool() {
    return tool;
  }

  /** Adds a layer over every picture, independent of the visibility of filters' marks. */
  public void addLayer(Consumer<OverlayCanvas> layer) {
    layers.add(layer);
  }

  /** Redraws the picture after a change of its layers. */
  public void redraw() {
    picture.draw(this::drawLayers);
  }

  @Override
  protected void layoutChildren() {
    double scale = viewpoint.scale();
    double left = viewpoint.left();
    double top = viewpoint.top();
    double density = PixelImage.density(this);
    picture.place(viewpoint, density);
    frame.setX(left - 0.5);
    frame.setY(top - 0.5);
    frame.setWidth(geometry.width() * scale + 1);
    frame.setHeight(geometry.height() * scale + 1);
    redraw();
    double room = getWidth() - 4;
    legend.resize(Math.min(legend.prefWidth(-1), room), legend.prefHeight(-1));
    legend.setOpacity(legend.minWidth(-1) > room ? 0 : 1);
    double legendX = Math.max(2, getWidth() - legend.getWidth() - 12);
    legend.relocate(legendX, getHeight() - legend.getHeight() - 10);
    readout.setMaxWidth(getWidth() - 24);
    showReadout(readout.getText());
  }

  private void drawLayers(OverlayCanvas canvas) {
    layers.forEach(layer -> layer.accept(canvas));
    tool.ifPresent(held -> held.draw(canvas));
    keys.draw(canvas);
  }

  private void scrolled(ScrollEvent event) {
    if (event.getDeltaY() == 0) {
      return;
    }
    double notches = event.getDeltaY() / Math.max(1, event.getMultiplierY());
    viewpoint.zoomAt(event.getX(), event.getY(), notches);
    event.consume();
  }

  private boolean worksWithTool(MouseEvent event) {
    return tool.isPresent() && event.getButton() == MouseButton.PRIMARY;
  }

  private void pressed(MouseEvent event) {
    requestFocus();
    dragX = event.getX();
    dragY = event.getY();
    if (worksWithTool(event)) {
      tool.get().pressed(sensorX(event), sensorY(event));
      redraw();
    }
  }

  private void released(MouseEvent event) {
    if (worksWithTool(event)) {
      tool.get().released(sensorX(event), sensorY(event));
      redraw();
    } else {
      setCursor(tool.isPresent() ? Cursor.CROSSHAIR : Cursor.DEFAULT);
    }
  }

  /** Column under the mouse, 0 at the middle of the first one. */
  private double sensorX(MouseEvent event) {
    return viewpoint.sensorX(event.getX());
  }

  /** Row under the mouse, upwards, 0 at the middle of the lowest one. */
  private double sensorY(MouseEvent event) {
    return viewpoint.sensorY(event.getY());
  }

  private void dragged(MouseEvent event) {
    if (worksWithTool(event)) {
      tool.get().dragged(sensorX(event), sensorY(event));
      redraw();
    } else if (viewpoint.isClose()) {
      setCursor(Cursor.CLOSED_HAND);
      viewpoint.move(dragX - event.getX(), event.getY() - dragY);
    }
    dragX = event.getX();
    dragY = event.getY();
    pointed(event);
  }

  @Override
  public boolean consumesArrows() {
    return tool.isPresent();
  }

  private void keyPressed(KeyEvent event) {
    if (tool.isEmpty() || !KeyPointer.takes(event.getCode())) {
      return;
    }
    keys.begin(
        pixel(viewpoint.sensorX(getWidth() / 2), geometry.width()),
        pixel(viewpoint.sensorY(getHeight() / 2), geometry.height()));
    keys.press(event.getCode(), event.isShiftDown(), tool.get(), geometry);
    viewpoint.ensureVisible(keys.x(), keys.y());
    point(keys.x(), keys.y());
    event.consume();
  }

  /** The pixel at a coordinate, or the nearest one. */
  static int pixel(double place, int size) {
    return (int) Math.max(0, Math.min(size - 1, Math.rint(place)));
  }

  private void pointed(MouseEvent event) {
    keys.end();
    point((int) Math.floor(sensorX(event) + 0.5), (int) Math.floor(sensorY(event) + 0.5));
  }

  private void clearPointer() {
    readout.setVisible(keys.isShown());
    if (!keys.isShown()) {
      pointed.set(Optional.empty());
    }
  }

  private void point(int x, int y) {
    boolean inside = geometry.contains(x, y);
    readout.setVisible(inside);
    pointed.set(inside ? Optional.of(PixelRegion.around(x, y, 0)) : Optional.empty());
    if (inside && (x != pointedX || y != pointedY || readout.getText().isEmpty())) {
      pointedX = x;
      pointedY = y;
      showReadout("x " + x + "   y " + y);
    }
  }

  private void showReadout(String text) {
    readout.setText(text);
    readout.autosize();
    boolean above = legend.isVisible() && readout.getWidth() + 24 > legend.getLayoutX();
    double bottom = above ? legend.getLayoutY() - 4 : getHeight() - 10;
    readout.relocate(12, bottom - readout.getHeight());
  }
}
