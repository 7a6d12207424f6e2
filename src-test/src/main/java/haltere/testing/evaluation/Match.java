package haltere.testing.evaluation;

/**
 * A true point and the matched point of a track.
 *
 * @param truth true position
 * @param track position of the track
 * @param switched whether the object had another track at its last match
 */
public record Match(ObjectPoint truth, ObjectPoint track, boolean switched) {}
