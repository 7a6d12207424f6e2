package haltere.ui.viewer.picture;

import haltere.core.overlay.OverlayCanvas;
import haltere.filters.frequency.PixelRegion;
import haltere.filters.frequency.RegionReading;
import java.util.Optional;

/**
 * The region of interest as it is drawn over the events, with what it is doing.
 *
 * <p>Thread rule: JavaFX thread only.
 */
public final class RegionLayer {
  private Optional<PixelRegion> region = Optional.empty();
  private RegionReading reading = RegionReading.NOTHING;

  /** Draws another region, or none. */
  public void setRegion(Optional<PixelRegion> newRegion) {
    region = newRegion;
    reading = RegionReading.NOTHING;
  }

  /** The region that is drawn. */
  public Optional<PixelRegion> region() {
    return region;
  }

  /** Takes the newest numbers of the region. */
  public void setReading(RegionReading newReading) {
    reading = newReading;
  }

  /** What the region is doing, in words. */
  public String words() {
    return marks().map(RegionMarks::words).orElse("");
  }

  /** Draws the region and what it is doing. */
  public void draw(OverlayCanvas canvas) {
    marks().ifPresent(marks -> marks.draw(canvas));
  }

  private Optional<RegionMarks> marks() {
    return region.map(pixels -> new RegionMarks(pixels, reading));
  }
}
