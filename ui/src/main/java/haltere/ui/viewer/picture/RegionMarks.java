package haltere.ui.viewer.picture;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.OverlayCanvas;
import haltere.filters.frequency.PixelRegion;
import haltere.filters.frequency.RegionReading;
import haltere.ui.viewer.controls.Texts;

/**
 * The region of interest as it is drawn over the events.
 *
 * @param region the pixels
 * @param reading what it is doing
 */
public record RegionMarks(PixelRegion region, RegionReading reading) {
  /** What the region is doing, in words. */
  public String words() {
    String rate = Texts.rate(reading.rateEps());
    return Double.isNaN(reading.frequencyHz())
        ? rate
        : rate + "   " + Texts.digits(reading.frequencyHz()) + " Hz";
  }

  /** Draws the region and what it is doing. */
  public void draw(OverlayCanvas canvas) {
    canvas.rectangle(
        region.left() - 0.5,
        region.bottom() - 0.5,
        region.width(),
        region.height(),
        MarkStyle.of(Role.REGION));
    canvas.text(
        region.left(), region.bottom() + region.height() + 1.0, words(), MarkStyle.of(Role.LABEL));
  }
}
