package haltere.filters.wing.internal.search;

import haltere.filters.wing.FlyGeometry;
import haltere.filters.wing.internal.stroke.StrokeSeed;

/**
 * A fly that the search has found.
 *
 * @param geometry of the fly
 * @param regionPx radius of the region of interest about the hinges
 * @param seeds left and right stroke; null for a wing that was not found
 */
public record FoundFly(FlyGeometry geometry, double regionPx, StrokeSeed[] seeds) {}
