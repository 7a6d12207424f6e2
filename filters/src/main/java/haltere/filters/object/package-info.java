/**
 * Tracker of moving objects of any shape.
 *
 * <p>Events change a grid of pixels ({@code ActivityGrid}). At each tick {@code EventAssociation}
 * shares them among components ({@code Component}: a position, a velocity, a {@code ShapeTemplate},
 * a {@code Presence}) and clutter ({@code ClutterMap}). {@code BirthDetector} begins components,
 * {@code RegionFinder} splits them, {@code ObjectRelations} decides which of them are one {@code
 * TrackedObject}. {@code ObjectTracker} runs these steps, {@link
 * haltere.filters.object.ObjectTrackerFilter} is the stage of a chain. Thread rule of all these
 * classes: one thread at a time.
 *
 * @since 0.1
 */
package haltere.filters.object;
