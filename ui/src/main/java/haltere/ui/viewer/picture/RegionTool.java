package haltere.ui.viewer.picture;

import haltere.core.event.SensorGeometry;
import haltere.filters.frequency.PixelRegion;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;

/** Draws the region of interest from corner to corner; a click removes it. */
public final class RegionTool implements ViewTool {
  private final Supplier<SensorGeometry> sensor;
  private final Consumer<Optional<PixelRegion>> consumer;
  private double fromX;
  private double fromY;
  private boolean drawn;

  /**
   * A tool for a picture of a sensor, whose size is requested whenever a region is drawn; a click
   * removes the region.
   */
  public RegionTool(Supplier<SensorGeometry> sensor, Consumer<Optional<PixelRegion>> consumer) {
    this.sensor = sensor;
    this.consumer = consumer;
  }

  @Override
  public String hint() {
    return "Drag over the picture to draw the region of interest; a click removes it.";
  }

  @Override
  public void pressed(double x, double y) {
    fromX = x;
    fromY = y;
    drawn = false;
  }

  @Override
  public void dragged(double x, double y) {
    SensorGeometry geometry = sensor.get();
    drawn = true;
    consumer.accept(
        Optional.of(
            PixelRegion.between(
                EventView.pixel(fromX, geometry.width()),
                EventView.pixel(fromY, geometry.height()),
                EventView.pixel(x, geometry.width()),
                EventView.pixel(y, geometry.height()))));
  }

  @Override
  public void released(double x, double y) {
    if (!drawn) {
      consumer.accept(Optional.empty());
    }
  }
}
