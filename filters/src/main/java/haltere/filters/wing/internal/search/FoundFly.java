package haltere.filters.wing.internal.search;

import haltere.filters.wing.FlyGeometry;
import haltere.filters.wing.internal.stroke.StrokeSeed;

/**
 * A fly that the search has found.
 *
 * @param geometry where it is
 * @param regionPx radius of the region of interest about the hinges
 * @param seeds its strokes, left and right; null for a wing that was not found
 */
public record FoundFly(FlyGeometry geometry, double regionPx, StrokeSeed[] seeds) {}
