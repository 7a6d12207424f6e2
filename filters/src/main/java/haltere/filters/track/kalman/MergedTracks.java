package haltere.filters.track.kalman;

/** What becomes of the tracks of two clusters that have become one. Thread rule: its caller's. */
final class MergedTracks {
  private MergedTracks() {}

  /**
   * Lets the older track go on with the cluster that is kept, or, where both are known to move
   * differently, lets the other wait until it appears again.
   */
  static void merge(EventBatch kept, EventBatch lost, Tracks tracks) {
    if (lost == null || lost.track == null) {
      return;
    }
    Track track = lost.track;
    if (kept == null || kept.track == null) {
      track.release(false);
      if (kept != null) {
        track.hold(kept);
      }
      return;
    }
    if (track.id > 0 && kept.track.id > 0 && track.movesUnlike(kept.track)) {
      track.release(true);
      return;
    }
    if (precedes(track, kept.track)) {
      Track younger = kept.track;
      younger.release(false);
      tracks.drop(younger);
      track.release(false);
      track.hold(kept);
    } else {
      track.release(false);
      tracks.drop(track);
    }
  }

  /** Whether the first goes on: what has an identity, has moved, and is older. */
  private static boolean precedes(Track first, Track second) {
    if (first.id == 0 || second.id == 0) {
      return first.id > 0;
    }
    if (first.part.isStill != second.part.isStill) {
      return second.part.isStill;
    }
    return first.bornUs < second.bornUs;
  }
}
