package haltere.filters.wing;

/**
 * A fly that the search has found.
 *
 * @param geometry where it is
 * @param seeds its strokes, left and right
 */
record FoundFly(FlyGeometry geometry, StrokeSeed[] seeds) {}
