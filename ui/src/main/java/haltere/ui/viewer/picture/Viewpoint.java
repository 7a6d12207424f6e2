package haltere.ui.viewer.picture;

import haltere.core.event.SensorGeometry;
import haltere.filters.frequency.PixelRegion;

/**
 * The visible part of a sensor and its scale, with the mapping in both directions.
 *
 * <p>Places on the sensor are counted from the middle of its left bottom pixel, upwards; those in
 * the view from its left top corner, downwards.
 */
public final class Viewpoint {
  private static final double MAX_PIXEL = 64;
  private static final double MAX_LOSS = 1.06;
  private static final double ZOOM_PER_NOTCH = 1.2;
  private static final double ZOOM_MARGIN = 0.9;

  private SensorGeometry sensor = new SensorGeometry(1, 1);
  private double width;
  private double height;

  /** 1 shows the whole sensor. */
  private double zoom = 1;

  /** Middle of the view, in pixels of the sensor from its left bottom corner. */
  private double centreX;

  private double centreY;

  private final Runnable changed;

  /** A viewpoint with a listener to its changes. */
  Viewpoint(Runnable changed) {
    this.changed = changed;
  }

  /** Another sensor, all of which is shown. */
  void setSensor(SensorGeometry newSensor) {
    sensor = newSensor;
    showAll();
  }

  double width() {
    return width;
  }

  double height() {
    return height;
  }

  /** The view has another size. */
  void setSize(double newWidth, double newHeight) {
    width = newWidth;
    height = newHeight;
  }

  /** Shows the whole sensor. */
  public void showAll() {
    zoom = 1;
    centreX = sensor.width() / 2.0;
    centreY = sensor.height() / 2.0;
    changed.run();
  }

  /** Whether less than the whole sensor is shown. */
  boolean isClose() {
    return zoom > 1;
  }

  /** Enlarges a region as far as the view has room. */
  public void zoomTo(PixelRegion region) {
    double wanted = Math.min(width / region.width(), height / region.height()) * ZOOM_MARGIN;
    zoom = Math.max(1, Math.min(MAX_PIXEL, wanted) / fit());
    centreX = region.left() + region.width() / 2.0;
    centreY = region.bottom() + region.height() / 2.0;
    changed.run();
  }

  /** Makes the picture larger or smaller around its middle. */
  public void zoomBy(double factor) {
    zoom = Math.max(1, Math.min(Math.max(1, MAX_PIXEL / fit()), zoom * factor));
    if (zoom < 1.01) {
      showAll();
    }
    changed.run();
  }

  /** Zooms; the position under the mouse is fixed. */
  void zoomAt(double viewX, double viewY, double notches) {
    double sensorX = sensorX(viewX);
    double sensorY = sensorY(viewY);
    zoomBy(Math.pow(ZOOM_PER_NOTCH, notches));
    if (isClose()) {
      centreX += sensorX - sensorX(viewX);
      centreY += sensorY - sensorY(viewY);
      clamp();
    }
  }

  /** Pans by shares of the view. */
  public void pan(double right, double up) {
    move(right * width, up * height);
  }

  /** Pans by units of the view to the right and up. */
  void move(double right, double up) {
    centreX += right / scale();
    centreY += up / scale();
    clamp();
  }

  /** Pans as far as needed to show a position on the sensor. */
  void ensureVisible(double sensorX, double sensorY) {
    double x = viewX(sensorX);
    double y = viewY(sensorY);
    move(x - Math.max(0, Math.min(width, x)), Math.max(0, Math.min(height, y)) - y);
  }

  private void clamp() {
    centreX = Math.max(0, Math.min(sensor.width(), centreX));
    centreY = Math.max(0, Math.min(sensor.height(), centreY));
    changed.run();
  }

  /** Units of the view per pixel of the sensor. */
  public double scale() {
    double fit = fit() * zoom;
    double whole = Math.floor(fit);
    // integer factors draw all pixels equally, unless they leave much space empty
    return zoom == 1 && whole >= 1 && fit < whole * MAX_LOSS ? whole : fit;
  }

  /** Scale at which the whole sensor just fits. */
  private double fit() {
    return Math.min(width / sensor.width(), height / sensor.height());
  }

  /** The sensor's left edge in the view. */
  double left() {
    return Math.rint(width / 2 - centreX * scale());
  }

  /** The sensor's top edge in the view. */
  double top() {
    return Math.rint(height / 2 - (sensor.height() - centreY) * scale());
  }

  /** View coordinate of a sensor column, from the left. */
  public double viewX(double sensorX) {
    return width / 2 + (sensorX + 0.5 - centreX) * scale();
  }

  /** View coordinate of a sensor row, from the top. */
  public double viewY(double sensorY) {
    return height / 2 - (sensorY + 0.5 - centreY) * scale();
  }

  double sensorX(double viewX) {
    return centreX + (viewX - width / 2) / scale() - 0.5;
  }

  double sensorY(double viewY) {
    return centreY - (viewY - height / 2) / scale() - 0.5;
  }
}
