package haltere.ui.viewer.picture;

import haltere.filters.frequency.PixelRegion;
import java.util.Optional;

/**
 * Overlays of a picture or a film.
 *
 * @param marks whether the marks of the filters do
 * @param region the region of interest, with its rate and frequency
 * @param tape the measured line
 */
public record Overlays(boolean marks, Optional<PixelRegion> region, Optional<MeasuredLine> tape) {}
