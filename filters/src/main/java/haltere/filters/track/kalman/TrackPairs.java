package haltere.filters.track.kalman;

import haltere.filters.cluster.ClusterReadings;
import haltere.filters.estimation.Gate;
import haltere.filters.track.Assignment;
import haltere.filters.track.LifeSettings;
import java.util.Arrays;

/**
 * Which batch of events belongs to which track where that is in question, and which tracks are in
 * one another's way. Thread rule: that of its owner.
 */
final class TrackPairs {
  /** Tracks are contested within this many of their events' standard deviations. */
  private static final double CONTESTED_SPREADS = 2.5;

  /** Tracks this much farther apart are decided together. */
  private static final double NEAR_FACTOR = 2;

  /** What a track's own cluster is preferred by, as a difference of a normalised square. */
  private static final double OWN_BONUS = 4;

  /** For so long after they were near each other the events of clusters are not sorted yet. */
  private static final long SORTING_US = 60_000;

  private static final double UNASSIGNED = 1000;

  /** A track that was thrown back appears within this time and so many of its radii. */
  private static final long THROWN_BACK_US = 200_000;

  private static final double THROWN_BACK_RADII = 1.5;

  private final double threshold;
  private Assignment assignment = new Assignment(8, 8);
  private int room = 8;
  private EventBatch[] batches = new EventBatch[8];
  private int batchCount;
  private Track[] tracks = new Track[8];
  private int trackCount;

  TrackPairs(LifeSettings settings) {
    threshold = Gate.sigmas(settings.gateSigmas()).threshold(2);
  }

  /** The largest normalised innovation squared that is believed. */
  double threshold() {
    return threshold;
  }

  /** Marks the tracks that are near others at the time that they have looked at. */
  static void markContested(Tracks all, long timeUs) {
    for (int i = 0; i < all.count(); i++) {
      Track track = all.get(i);
      track.nearOther = false;
      track.nearUnlike = false;
      track.contested = false;
    }
    for (int i = 0; i < all.count(); i++) {
      Track track = all.get(i);
      for (int j = i + 1; track.id > 0 && j < all.count(); j++) {
        Track other = all.get(j);
        if (other.id > 0 && areNear(track, other)) {
          markPair(track, other);
        }
      }
    }
    for (int i = 0; i < all.count(); i++) {
      all.get(i).keepContested(timeUs, SORTING_US);
    }
  }

  private static void markPair(Track a, Track b) {
    a.nearOther = true;
    b.nearOther = true;
    if (!(a.nearUnlike && b.nearUnlike) && a.movesUnlike(b)) {
      a.nearUnlike = true;
      b.nearUnlike = true;
    }
    double reach = contestedReach(a, b);
    if (squaredDistance(a, b) < reach * reach) {
      a.contested = true;
      b.contested = true;
    }
  }

  /** Whether which of two tracks is which may be in question. */
  static boolean areNear(Track a, Track b) {
    double far = Math.max(NEAR_FACTOR * contestedReach(a, b), a.radiusPx + b.radiusPx);
    return squaredDistance(a, b) < far * far;
  }

  private static double contestedReach(Track a, Track b) {
    return CONTESTED_SPREADS * (a.spreadPx + b.spreadPx);
  }

  private static double squaredDistance(Track a, Track b) {
    double dx = a.nowXPx - b.nowXPx;
    double dy = a.nowYPx - b.nowYPx;
    return dx * dx + dy * dy;
  }

  void start() {
    batchCount = 0;
    trackCount = 0;
  }

  void addBatch(EventBatch batch) {
    if (batchCount == batches.length) {
      batches = Arrays.copyOf(batches, 2 * batchCount);
    }
    batches[batchCount++] = batch;
  }

  /**
   * Adds the tracks that are in question: those without a cluster, those whose cluster is, and
   * those whose cluster is silent, for that may be at an empty place, and another at their thing.
   */
  void addTracks(Tracks all, long timeUs) {
    for (int i = 0; i < all.count(); i++) {
      Track track = all.get(i);
      boolean silent = timeUs - track.heardUs > EventBatches.LONGEST_US;
      if (track.batch == null || silent || contains(track.batch)) {
        add(track);
      }
    }
  }

  private void add(Track track) {
    if (trackCount == tracks.length) {
      tracks = Arrays.copyOf(tracks, 2 * trackCount);
    }
    tracks[trackCount++] = track;
  }

  int batchCount() {
    return batchCount;
  }

  EventBatch batch(int j) {
    return batches[j];
  }

  private boolean contains(EventBatch batch) {
    for (int j = 0; j < batchCount; j++) {
      if (batches[j] == batch) {
        return true;
      }
    }
    return false;
  }

  /** States what each pair within the gate costs: −2 ln of its likelihood. */
  void costs(Measurement measurement, ClusterReadings readings, long timeUs) {
    int needed = Math.max(batchCount, trackCount);
    if (needed > room) {
      room = 2 * needed;
      assignment = new Assignment(room, room);
    }
    assignment.start(trackCount, batchCount);
    for (int i = 0; i < trackCount; i++) {
      for (int j = 0; j < batchCount; j++) {
        measurement.of(batches[j], tracks[i], readings, timeUs);
        if (!isWithinReach(tracks[i], batches[j], measurement)) {
          continue;
        }
        if (tracks[i].compare(measurement) <= threshold) {
          double bonus = tracks[i].batch == batches[j] ? OWN_BONUS : 0;
          assignment.setCost(i, j, -2 * tracks[i].logLikelihood() - bonus);
        }
      }
    }
  }

  /** What a track can have become in the time, whatever its covariance says. */
  private static boolean isWithinReach(Track track, EventBatch batch, Measurement measurement) {
    double reach = 2 * Math.max(track.radiusPx, batch.radiusPx);
    return Math.hypot(measurement.x - track.nowXPx, measurement.y - track.nowYPx) < reach
        || track.batch == batch;
  }

  void solve() {
    assignment.solve(UNASSIGNED, UNASSIGNED);
  }

  /** The track that a batch was given to, or null. */
  Track winner(int j) {
    int row = assignment.rowOf(j);
    return row == Assignment.NONE ? null : tracks[row];
  }

  /**
   * A track without a cluster that may have become what is seen now though it was not expected
   * there, or null: one that has stopped and begins to move again, or was thrown back.
   */
  static Track unexpectedAt(Measurement measurement, Tracks all, long timeUs) {
    Track nearest = null;
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < all.count(); i++) {
      Track track = all.get(i);
      if (track.id == 0 || track.batch != null) {
        continue;
      }
      double fromLost = Math.hypot(measurement.x - track.lostXPx, measurement.y - track.lostYPx);
      boolean justLost = timeUs - track.heardUs <= THROWN_BACK_US;
      double reach =
          justLost ? THROWN_BACK_RADII * track.radiusPx : track.radiusPx + track.stoppingPx();
      boolean isThere =
          fromLost < reach
              || track.part.extent.distanceWhenLost(track, measurement.x, measurement.y)
                  < track.part.extent.radiusPx();
      if ((justLost || track.mayRest()) && isThere && fromLost < least) {
        nearest = track;
        least = fromLost;
      }
    }
    return nearest;
  }
}
