package haltere.ui.viewer;

import haltere.core.event.SensorGeometry;
import haltere.ui.overlay.JavaFxOverlayCanvas;
import haltere.ui.rendering.ColourMap;
import java.nio.IntBuffer;
import java.util.List;
import javafx.geometry.Rectangle2D;
import javafx.scene.AccessibleRole;
import javafx.scene.Cursor;
import javafx.scene.canvas.Canvas;
import javafx.scene.control.Label;
import javafx.scene.image.ImageView;
import javafx.scene.image.PixelBuffer;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.input.ScrollEvent;
import javafx.scene.layout.Background;
import javafx.scene.layout.Region;
import javafx.scene.shape.Rectangle;

/**
 * Shows frames: the events as square pixels, the marks over them, the pixel under the mouse in
 * words. The wheel zooms where the mouse is, dragging moves, a double click shows all again.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class EventView extends Region {
  private static final double MAX_PIXEL = 64;
  private static final double MAX_LOSS = 1.06;
  private static final double ZOOM_PER_NOTCH = 1.2;

  private final ImageView image = new ImageView();
  private final Canvas marks = new Canvas();
  private final JavaFxOverlayCanvas marksCanvas =
      new JavaFxOverlayCanvas(marks.getGraphicsContext2D());
  private final Label readout = new Label();

  private SensorGeometry geometry = new SensorGeometry(1, 1);
  private PixelBuffer<IntBuffer> pixels;
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

  EventView() {
    getStyleClass().add("event-view");
    setId("event-view");
    setAccessibleRole(AccessibleRole.IMAGE_VIEW);
    setAccessibleText("Events");
    setMinSize(160, 120);
    image.setSmooth(false);
    image.setManaged(false);
    marks.setManaged(false);
    marks.setMouseTransparent(true);
    readout.getStyleClass().add("readout");
    readout.setId("cursor-readout");
    readout.setMouseTransparent(true);
    readout.setManaged(false);
    readout.setVisible(false);
    getChildren().addAll(image, marks, readout);
    Rectangle clip = new Rectangle();
    clip.widthProperty().bind(widthProperty());
    clip.heightProperty().bind(heightProperty());
    setClip(clip);
    setOnScroll(this::scrolled);
    setOnMousePressed(
        event -> {
          dragX = event.getX();
          dragY = event.getY();
        });
    setOnMouseDragged(this::dragged);
    setOnMouseReleased(event -> setCursor(Cursor.DEFAULT));
    setOnMouseClicked(
        event -> {
          if (event.getButton() == MouseButton.PRIMARY && event.getClickCount() == 2) {
            showAll();
          }
        });
    setOnMouseMoved(this::pointed);
    setOnMouseExited(event -> readout.setVisible(false));
  }

  /** Prepares for frames of another sensor. */
  void setGeometry(SensorGeometry newGeometry, ColourMap colours) {
    dark = colours.dark();
    setBackgroundColour(colours);
    if (!newGeometry.equals(geometry) || pixels == null) {
      geometry = newGeometry;
      int[] empty = new int[geometry.pixels()];
      java.util.Arrays.fill(empty, colours.background());
      pixels =
          new PixelBuffer<>(
              geometry.width(),
              geometry.height(),
              IntBuffer.wrap(empty),
              PixelFormat.getIntArgbPreInstance());
      image.setImage(new WritableImage(pixels));
      showAll();
    }
  }

  /** Fills what the picture leaves free. */
  void setBackgroundColour(ColourMap colours) {
    setBackground(Background.fill(JavaFxOverlayCanvas.colour(colours.background())));
  }

  /** Shows a frame of the current sensor. */
  void show(DisplayFrame frame) {
    if (!frame.geometry.equals(geometry)) {
      return;
    }
    pixels.updateBuffer(
        buffer -> {
          buffer.getBuffer().put(0, frame.argb);
          return null;
        });
    shownMarks = frame.marks;
    dark = frame.dark;
    drawMarks();
  }

  /** Shows or hides the marks. */
  void setMarksVisible(boolean visible) {
    marksVisible = visible;
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
    // only what is in sight, so that a large zoom costs no more than a small one
    int fromX = clamp((int) Math.floor(-left / scale), geometry.width() - 1);
    int fromY = clamp((int) Math.floor(-top / scale), geometry.height() - 1);
    int toX = clamp((int) Math.ceil((getWidth() - left) / scale), geometry.width());
    int toY = clamp((int) Math.ceil((getHeight() - top) / scale), geometry.height());
    int columns = Math.max(1, toX - fromX);
    int rows = Math.max(1, toY - fromY);
    image.setViewport(new Rectangle2D(fromX, fromY, columns, rows));
    image.setFitWidth(columns * scale);
    image.setFitHeight(rows * scale);
    image.relocate(left + fromX * scale, top + fromY * scale);
    if (marks.getWidth() != getWidth() || marks.getHeight() != getHeight()) {
      marks.setWidth(getWidth());
      marks.setHeight(getHeight());
    }
    marksCanvas.setView(scale, left, top + geometry.height() * scale, dark);
    marksDrawn = true;
    drawMarks();
    readout.autosize();
    readout.relocate(12, getHeight() - readout.getHeight() - 10);
  }

  private void drawMarks() {
    if (marksDrawn) {
      marks.getGraphicsContext2D().clearRect(0, 0, marks.getWidth(), marks.getHeight());
      marksDrawn = false;
    }
    if (marksVisible) {
      long before = marksCanvas.marks();
      for (DisplayFrame.Marks<?> snapshot : shownMarks) {
        snapshot.draw(marksCanvas);
      }
      marksDrawn = marksCanvas.marks() != before;
    }
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

  private void dragged(MouseEvent event) {
    if (zoom > 1) {
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
    if (inside) {
      readout.setText("x " + x + "   y " + y);
      readout.autosize();
      readout.relocate(12, getHeight() - readout.getHeight() - 10);
    }
  }

  private static int clamp(int value, int max) {
    return Math.max(0, Math.min(max, value));
  }
}
