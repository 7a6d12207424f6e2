package haltere.ui.viewer;

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
    return marks().map(RegionMarks::words).orElse("");
  }

  void draw(OverlayCanvas canvas) {
    marks().ifPresent(marks -> marks.draw(canvas));
  }

  private Optional<RegionMarks> marks() {
    return region.map(pixels -> new RegionMarks(pixels, reading));
  }
}
