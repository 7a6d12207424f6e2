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
 * Shows frames: the events as square pixels, the marks over them, the pixel under the mouse in
 * words. The wheel zooms where the mouse is, dragging moves, a double click shows all again. While
 * a tool is in the hand the arrow keys and Enter work with it as the mouse does.
 */
public final class EventView extends Region implements ArrowKeys {
  /** Told which pixel is under the mouse. */
  public interface PointerListener {
    /** The mouse is over a pixel, or over none. */
    void pointed(int x, int y, boolean over);
  }

  private final Viewpoint viewpoint = new Viewpoint(this::requestLayout);
  private final SensorPicture picture = new SensorPicture();
  private final Rectangle frame = new Rectangle();
  private final Label readout = Controls.named(new Label(), "cursor-readout", "readout");
  private final ScaleLegend legend = new ScaleLegend();
  private PointerListener pointer = (x, y, over) -> {};
  private int pointedX;
  private int pointedY;

  private SensorGeometry geometry = new SensorGeometry(1, 1);
  private double dragX;
  private double dragY;
  private Optional<ViewTool> tool = Optional.empty();
  private final KeyPointer keys = new KeyPointer();

  /** What has been asked for another frame that has not come yet. */
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
    getChildren().add(picture.node());
    getChildren().addAll(frame, readout, legend);
    widthProperty().subscribe(() -> viewpoint.setSize(getWidth(), getHeight()));
    heightProperty().subscribe(() -> viewpoint.setSize(getWidth(), getHeight()));
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
    setOnMouseExited(event -> pointNowhere());
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
   * Shows the newest frame of a sink, true if there is one; else has one painted, on the processing
   * thread, where another one is wanted.
   */
  public boolean show(DisplaySink sink, Executor processing) {
    DisplayFrame frame = sink.maker().exchange().fetch();
    if (frame != null) {
      asked = Optional.empty();
      show(frame);
    } else if (sink.maker().isStale() && !asked.equals(Optional.of(sink))) {
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
          .ifPresent(pixel -> showReadout(pixel.words()));
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

  /** Where another thread may draw frames as they are on the screen; empty where it need not. */
  public Optional<ScreenPlace> screenPlace() {
    return picture.screenPlace();
  }

  /** Tells somebody which pixel is under the mouse. */
  public void setPointerListener(PointerListener listener) {
    pointer = listener;
  }

  /** Which part of the sensor is seen, and how large. */
  public Viewpoint viewpoint() {
    return viewpoint;
  }

  /** What the ends of the colours mean. */
  public ScaleLegend legend() {
    return legend;
  }

  /** Makes each pixel of the sensor as large as it gets, where the mouse was last. */
  public void zoomToPixels() {
    viewpoint.zoomTo(PixelRegion.around(pointedX, pointedY, 4));
  }

  /** Takes a tool into the hand, in place of the one that is there, or none. */
  public void setTool(Optional<ViewTool> newTool) {
    tool.ifPresent(ViewTool::putAside);
    tool = newTool;
    if (keys.isShown()) {
      keys.end();
      pointNowhere();
    }
    if (tool.isPresent()) {
      requestFocus();
    }
    setCursor(tool.isPresent() ? Cursor.CROSSHAIR : Cursor.DEFAULT);
    toolListeners.forEach(listener -> listener.accept(tool));
    redraw();
  }

  /** Tells somebody which tool is in the hand, whenever that changes. */
  public void onToolChange(Consumer<Optional<ViewTool>> listener) {
    toolListeners.add(listener);
  }

  /** Tells somebody of every frame that is shown, before its marks are drawn. */
  public void onFrame(Consumer<DisplayFrame> listener) {
    frameListeners.add(listener);
  }

  /** The tool in the hand. */
  public Optional<ViewTool> tool() {
    return tool;
  }

  /** Draws something over every picture, whether marks of filters are shown or not. */
  public void addLayer(Consumer<OverlayCanvas> layer) {
    layers.add(layer);
  }

  /** Draws the picture once more, because what lies over it has changed. */
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
    showReadout(readout.getText());
    legend.autosize();
    legend.relocate(getWidth() - legend.getWidth() - 12, getHeight() - legend.getHeight() - 10);
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
  public boolean keepsArrows() {
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
    viewpoint.keepInSight(keys.x(), keys.y());
    point(keys.x(), keys.y());
    event.consume();
  }

  /** The pixel at a place, or the nearest one. */
  static int pixel(double place, int size) {
    return (int) Math.max(0, Math.min(size - 1, Math.rint(place)));
  }

  private void pointed(MouseEvent event) {
    keys.end();
    point((int) Math.floor(sensorX(event) + 0.5), (int) Math.floor(sensorY(event) + 0.5));
  }

  private void pointNowhere() {
    readout.setVisible(keys.isShown());
    if (!keys.isShown()) {
      pointer.pointed(0, 0, false);
    }
  }

  private void point(int x, int y) {
    boolean inside = geometry.contains(x, y);
    readout.setVisible(inside);
    pointer.pointed(x, y, inside);
    if (inside && (x != pointedX || y != pointedY || readout.getText().isEmpty())) {
      pointedX = x;
      pointedY = y;
      showReadout("x " + x + "   y " + y);
    }
  }

  private void showReadout(String words) {
    readout.setText(words);
    readout.autosize();
    readout.relocate(12, getHeight() - readout.getHeight() - 10);
  }
}
