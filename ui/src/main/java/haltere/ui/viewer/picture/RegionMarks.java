package haltere.ui.viewer.picture;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.OverlayCanvas;
import haltere.filters.frequency.PixelRegion;
import haltere.filters.frequency.RegionMeasurement;
import haltere.ui.viewer.controls.Texts;

/**
 * The region of interest as drawn over the events.
 *
 * @param region the pixels
 * @param reading its measurement
 */
public record RegionMarks(PixelRegion region, RegionMeasurement reading) {
  /** The measurement as text. */
  public String label() {
    String rate = Texts.rate(reading.rateEps());
    return Double.isNaN(reading.frequencyHz())
        ? rate
        : rate + "   " + Texts.digits(reading.frequencyHz()) + " Hz";
  }

  /** Draws the region and its measurement. */
  public void draw(OverlayCanvas canvas) {
    canvas.rectangle(
        region.left() - 0.5,
        region.bottom() - 0.5,
        region.width(),
        region.height(),
        MarkStyle.of(Role.REGION));
    canvas.text(
        region.left(), region.bottom() + region.height() + 1.0, label(), MarkStyle.of(Role.LABEL));
  }
}
