package haltere.testing.evaluation;

/**
 * A point of truth and the point of a track that stands for it.
 *
 * @param truth where the object is
 * @param track where the track says it is
 * @param switched whether the object had another track the last time it had one
 */
public record Match(ObjectPoint truth, ObjectPoint track, boolean switched) {}
