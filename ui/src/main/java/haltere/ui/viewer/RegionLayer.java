package haltere.ui.viewer;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.OverlayCanvas;
import haltere.ui.measure.PixelRegion;
import haltere.ui.measure.RegionReading;
import java.util.Optional;

/**
 * The region of interest as it is drawn over the events, with what it is doing.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class RegionLayer {
  private Optional<PixelRegion> region = Optional.empty();
  private RegionReading reading = RegionReading.NOTHING;

  void setRegion(Optional<PixelRegion> newRegion) {
    region = newRegion;
    reading = RegionReading.NOTHING;
  }

  Optional<PixelRegion> region() {
    return region;
  }

  void setReading(RegionReading newReading) {
    reading = newReading;
  }

  /** What the region is doing, in words. */
  String words() {
    String rate = Texts.quantity(reading.rateEps()) + " ev/s";
    return Double.isNaN(reading.frequencyHz())
        ? rate
        : rate + "   " + Texts.digits(reading.frequencyHz()) + " Hz";
  }

  void draw(OverlayCanvas canvas) {
    region.ifPresent(
        drawn -> {
          canvas.rectangle(
              drawn.left() - 0.5,
              drawn.bottom() - 0.5,
              drawn.width(),
              drawn.height(),
              MarkStyle.of(Role.REGION));
          canvas.text(
              drawn.left(),
              drawn.bottom() + drawn.height() + 1.0,
              words(),
              MarkStyle.of(Role.LABEL));
        });
  }
}
