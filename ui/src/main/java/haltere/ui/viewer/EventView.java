package haltere.ui.viewer;

import haltere.core.event.SensorGeometry;
import haltere.core.overlay.OverlayCanvas;
import haltere.ui.measure.PixelRegion;
import haltere.ui.overlay.JavaFxOverlayCanvas;
import haltere.ui.rendering.ColourMap;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.application.ConditionalFeature;
import javafx.application.Platform;
import javafx.scene.AccessibleRole;
import javafx.scene.Cursor;
import javafx.scene.canvas.Canvas;
import javafx.scene.control.Label;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.ScrollEvent;
import javafx.scene.layout.Region;
import javafx.scene.shape.Rectangle;

/**
 * Shows frames: the events as square pixels, the marks over them, the pixel under the mouse in
 * words. The wheel zooms where the mouse is, dragging moves, a double click shows all again.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class EventView extends Region {
  /** Told which pixel is under the mouse. */
  interface PointerListener {
    /** The mouse is over a pixel, or over none. */
    void pointed(int x, int y, boolean over);
  }

  private static final double MAX_PIXEL = 64;
  private static final double MAX_LOSS = 1.06;
  private static final double ZOOM_PER_NOTCH = 1.2;
  private static final double ZOOM_MARGIN = 0.9;

  private final SensorPicture picture =
      new SensorPicture(!Platform.isSupported(ConditionalFeature.SCENE3D));
  private final Canvas marks = new Canvas();
  private final JavaFxOverlayCanvas marksCanvas =
      new JavaFxOverlayCanvas(marks.getGraphicsContext2D());
  private final Rectangle frame = new Rectangle();
  private final Label readout = new Label();
  private final ScaleLegend legend = new ScaleLegend();
  private PointerListener pointer = (x, y, over) -> {};
  private int pointedX;
  private int pointedY;

  private SensorGeometry geometry = new SensorGeometry(1, 1);
  private List<DisplayFrame.Marks<?>> shownMarks = List.of();
  private boolean dark = true;
  private boolean marksVisible = true;
  private boolean marksDrawn;

  /** 1 shows the whole sensor. */
  private double zoom = 1;

  /** Middle of the view, in pixels of the sensor from its left bottom corner. */
  private double centreX;

  private double centreY;
  private double dragX;
  private double dragY;
  private Optional<ViewTool> tool = Optional.empty();
  private final List<Consumer<OverlayCanvas>> layers = new ArrayList<>();
  private final List<Consumer<Optional<ViewTool>>> toolListeners = new ArrayList<>();
  private final List<Consumer<DisplayFrame>> frameListeners = new ArrayList<>();

  EventView() {
    getStyleClass().add("event-view");
    setId("event-view");
    setAccessibleRole(AccessibleRole.IMAGE_VIEW);
    setAccessibleText("Events");
    setFocusTraversable(true);
    setMinSize(160, 120);
    marks.setManaged(false);
    marks.setMouseTransparent(true);
    frame.getStyleClass().add("sensor-frame");
    frame.setManaged(false);
    frame.setMouseTransparent(true);
    readout.getStyleClass().add("readout");
    readout.setId("cursor-readout");
    readout.setMouseTransparent(true);
    readout.setManaged(false);
    readout.setVisible(false);
    getChildren().addAll(picture.node(), frame, marks, readout, legend);
    Rectangle clip = new Rectangle();
    clip.widthProperty().bind(widthProperty());
    clip.heightProperty().bind(heightProperty());
    setClip(clip);
    setOnScroll(this::scrolled);
    setOnMousePressed(this::pressed);
    setOnMouseDragged(this::dragged);
    setOnMouseReleased(this::released);
    setOnMouseClicked(
        event -> {
          if (!worksWithTool(event) && event.getClickCount() == 2) {
            showAll();
          }
        });
    setOnMouseMoved(this::pointed);
    setOnMouseExited(
        event -> {
          readout.setVisible(false);
          pointer.pointed(0, 0, false);
        });
  }

  /** Prepares for frames of another sensor. */
  void setGeometry(SensorGeometry newGeometry, ColourMap colours) {
    dark = colours.dark();
    setBackgroundColour(colours);
    if (!newGeometry.equals(geometry)) {
      geometry = newGeometry;
      picture.setGeometry(geometry, colours.background());
      showAll();
    }
  }

  /**
   * Changes the colour of what lies behind the events. Around the picture the scene's own fill is
   * seen: this view has no background, because without a graphics card each layer costs.
   */
  void setBackgroundColour(ColourMap colours) {
    picture.setBackground(colours.background());
  }

  /** Shows a frame of the current sensor. */
  void show(DisplayFrame frame) {
    if (!frame.geometry.equals(geometry)) {
      return;
    }
    picture.show(frame.argb);
    shownMarks = frame.marks;
    dark = frame.dark;
    if (readout.isVisible()) {
      frame
          .pixel
          .filter(pixel -> pixel.x() == pointedX && pixel.y() == pointedY)
          .ifPresent(pixel -> showReadout(pixel.words()));
    }
    legend.show(frame.scale);
    frameListeners.forEach(listener -> listener.accept(frame));
    drawMarks();
  }

  /** Shows or hides the marks. */
  void setMarksVisible(boolean visible) {
    marksVisible = visible;
    drawMarks();
  }

  /** Tells somebody which pixel is under the mouse. */
  void setPointerListener(PointerListener listener) {
    pointer = listener;
  }

  /** What the ends of the colours mean. */
  ScaleLegend legend() {
    return legend;
  }

  /** Enlarges a region as far as the view has room. */
  void zoomTo(PixelRegion region) {
    double wanted =
        Math.min(getWidth() / region.width(), getHeight() / region.height()) * ZOOM_MARGIN;
    zoom = Math.max(1, Math.min(MAX_PIXEL, wanted) / fit());
    centreX = region.left() + region.width() / 2.0;
    centreY = region.bottom() + region.height() / 2.0;
    requestLayout();
  }

  /** Makes the picture larger or smaller around its middle. */
  void zoomBy(double factor) {
    zoom = Math.max(1, Math.min(Math.max(1, MAX_PIXEL / fit()), zoom * factor));
    if (zoom < 1.01) {
      showAll();
    }
    requestLayout();
  }

  /** Makes each pixel of the sensor as large as it gets, where the mouse was last. */
  void zoomToPixels() {
    zoomTo(PixelRegion.around(pointedX, pointedY, 4));
  }

  /** Moves the picture by shares of the view. */
  void pan(double right, double up) {
    centreX += right * getWidth() / scale();
    centreY += up * getHeight() / scale();
    keepInside();
    requestLayout();
  }

  /** Takes a tool into the hand, in place of the one that is there, or none. */
  void setTool(Optional<ViewTool> newTool) {
    tool.ifPresent(ViewTool::putAside);
    tool = newTool;
    setCursor(tool.isPresent() ? Cursor.CROSSHAIR : Cursor.DEFAULT);
    toolListeners.forEach(listener -> listener.accept(tool));
    drawMarks();
  }

  /** Tells somebody which tool is in the hand, whenever that changes. */
  void onToolChange(Consumer<Optional<ViewTool>> listener) {
    toolListeners.add(listener);
  }

  /** Tells somebody of every frame that is shown, before its marks are drawn. */
  void onFrame(Consumer<DisplayFrame> listener) {
    frameListeners.add(listener);
  }

  /** The tool in the hand. */
  Optional<ViewTool> tool() {
    return tool;
  }

  /** Draws something over every picture, whether marks of filters are shown or not. */
  void addLayer(Consumer<OverlayCanvas> layer) {
    layers.add(layer);
  }

  /** Draws what lies over the picture once more, because it has changed. */
  void redrawMarks() {
    drawMarks();
  }

  /** Shows the whole sensor. */
  void showAll() {
    zoom = 1;
    centreX = geometry.width() / 2.0;
    centreY = geometry.height() / 2.0;
    requestLayout();
  }

  /** Pixels of the screen per pixel of the sensor. */
  double scale() {
    double fit = fit() * zoom;
    double whole = Math.floor(fit);
    // whole numbers make all pixels alike, where they do not leave much room empty
    return zoom == 1 && whole >= 1 && fit < whole * MAX_LOSS ? whole : fit;
  }

  /** Scale at which the whole sensor just fits. */
  private double fit() {
    return Math.min(getWidth() / geometry.width(), getHeight() / geometry.height());
  }

  /** Where a place on the sensor is in this view, from the left. */
  double viewX(double sensorX) {
    return getWidth() / 2 + (sensorX + 0.5 - centreX) * scale();
  }

  /** Where a place on the sensor is in this view, from the top. */
  double viewY(double sensorY) {
    return getHeight() / 2 - (sensorY + 0.5 - centreY) * scale();
  }

  @Override
  protected void layoutChildren() {
    double scale = scale();
    double left = Math.rint(getWidth() / 2 - centreX * scale);
    double top = Math.rint(getHeight() / 2 - (geometry.height() - centreY) * scale);
    double density = getScene() == null ? 1 : getScene().getWindow().getRenderScaleX();
    picture.place(left, top, scale, getWidth(), getHeight(), density);
    frame.setX(left - 0.5);
    frame.setY(top - 0.5);
    frame.setWidth(geometry.width() * scale + 1);
    frame.setHeight(geometry.height() * scale + 1);
    // the marks get the sensor's part of the view and no more: a canvas costs by its size
    double canvasLeft = Math.max(0, left);
    double canvasTop = Math.max(0, top);
    marks.relocate(canvasLeft, canvasTop);
    marks.setWidth(Math.min(getWidth(), left + geometry.width() * scale) - canvasLeft);
    marks.setHeight(Math.min(getHeight(), top + geometry.height() * scale) - canvasTop);
    marksCanvas.setView(scale, left - canvasLeft, top + geometry.height() * scale - canvasTop);
    marksDrawn = true;
    drawMarks();
    readout.autosize();
    readout.relocate(12, getHeight() - readout.getHeight() - 10);
    legend.autosize();
    legend.relocate(getWidth() - legend.getWidth() - 12, getHeight() - legend.getHeight() - 10);
  }

  private void drawMarks() {
    if (marksDrawn) {
      marks.getGraphicsContext2D().clearRect(0, 0, marks.getWidth(), marks.getHeight());
      marksDrawn = false;
    }
    marksCanvas.setDark(dark);
    long before = marksCanvas.marks();
    if (marksVisible) {
      for (DisplayFrame.Marks<?> snapshot : shownMarks) {
        snapshot.draw(marksCanvas);
      }
    }
    layers.forEach(layer -> layer.accept(marksCanvas));
    tool.ifPresent(held -> held.draw(marksCanvas));
    marksDrawn = marksCanvas.marks() != before;
  }

  private void scrolled(ScrollEvent event) {
    if (event.getDeltaY() == 0) {
      return;
    }
    double before = scale();
    double sensorX = centreX + (event.getX() - getWidth() / 2) / before;
    double sensorY = centreY - (event.getY() - getHeight() / 2) / before;
    double notches = event.getDeltaY() / Math.max(1, event.getMultiplierY());
    zoom =
        Math.max(
            1, Math.min(Math.max(1, MAX_PIXEL / fit()), zoom * Math.pow(ZOOM_PER_NOTCH, notches)));
    if (zoom < 1.01) {
      showAll();
    } else {
      // the place under the mouse stays there
      centreX = sensorX - (event.getX() - getWidth() / 2) / scale();
      centreY = sensorY + (event.getY() - getHeight() / 2) / scale();
      keepInside();
    }
    requestLayout();
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
      drawMarks();
    }
  }

  private void released(MouseEvent event) {
    if (worksWithTool(event)) {
      tool.get().released(sensorX(event), sensorY(event));
      drawMarks();
    } else {
      setCursor(tool.isPresent() ? Cursor.CROSSHAIR : Cursor.DEFAULT);
    }
  }

  /** Column under the mouse, 0 at the middle of the first one. */
  private double sensorX(MouseEvent event) {
    return centreX + (event.getX() - getWidth() / 2) / scale() - 0.5;
  }

  /** Row under the mouse, upwards, 0 at the middle of the lowest one. */
  private double sensorY(MouseEvent event) {
    return centreY - (event.getY() - getHeight() / 2) / scale() - 0.5;
  }

  private void dragged(MouseEvent event) {
    if (worksWithTool(event)) {
      tool.get().dragged(sensorX(event), sensorY(event));
      drawMarks();
    } else if (zoom > 1) {
      setCursor(Cursor.CLOSED_HAND);
      centreX -= (event.getX() - dragX) / scale();
      centreY += (event.getY() - dragY) / scale();
      keepInside();
      requestLayout();
    }
    dragX = event.getX();
    dragY = event.getY();
    pointed(event);
  }

  private void keepInside() {
    centreX = Math.max(0, Math.min(geometry.width(), centreX));
    centreY = Math.max(0, Math.min(geometry.height(), centreY));
  }

  private void pointed(MouseEvent event) {
    int x = (int) Math.floor(centreX + (event.getX() - getWidth() / 2) / scale());
    int y = (int) Math.floor(centreY - (event.getY() - getHeight() / 2) / scale());
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
