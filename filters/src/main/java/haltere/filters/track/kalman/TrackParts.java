package haltere.filters.track.kalman;

import haltere.filters.track.KalmanTracksSettings;

/**
 * Which tracks are parts of one thing. A thing that is long or has many edges, a person say, is
 * several clusters side by side, of which each has a track; the thing has one identity, that of one
 * of them, and the others have none and are not shown.
 *
 * <p>A track is a part of another from the beginning if it begins in touch with it: what was never
 * seen by itself is no thing. So is what begins beside an edge that moves, or with it, until it is
 * known to move otherwise: edges appear and vanish with the direction in which a thing moves. Two
 * that were seen by themselves are one after they have been in touch for as long as two clusters
 * that were seen apart are before they merge. A part is a thing of its own when it has not been in
 * touch with the others for a while, and does not move with them either. What has a round outline
 * of its own is a whole and no part. If the track that is shown ends, the part with the most events
 * goes on with its identity. Thread rule: that of its owner.
 */
final class TrackParts {
  /** Up to how many of their radii apart clusters are in touch. */
  private static final double TOUCHING_RADII = 1.2;

  /** The same of clusters that are one thing's already. */
  private static final double HOLDING_RADII = 2;

  /** What moves with a thing is its part as far as this from it. */
  private static final double TOGETHER_RADII = 5;

  /** What begins beside an edge as near as this may be of its thing. */
  private static final double BESIDE_RADII = 3;

  /** The edges of a thing that begins to move appear within this time. */
  private static final long APPEARING_US = 150_000;

  /** Apart from the others for so long, a part is a thing of its own. */
  private static final long APART_US = 60_000;

  /** The same of one that is where the others are, though not in touch. */
  private static final long WITHIN_US = 500_000;

  /** Two that keep beside each other like this for so long, and were never alone, are one. */
  private static final long QUIET_US = 300_000;

  /** By how much of their radii one may have moved beside the other meanwhile. */
  private static final double QUIET_RADII = 0.5;

  /** A thing is shown elsewhere when its place was not known well enough for so many steps. */
  private static final int UNSURE_STEPS = 5;

  private final Tracks tracks;
  private final StandingPlaces standing = new StandingPlaces();
  private boolean allowed;
  private boolean inPixels;
  private long apartTogetherUs;

  TrackParts(Tracks tracks) {
    this.tracks = tracks;
  }

  /** Goes on by other rules; on a road there are vehicles and no parts. */
  void apply(KalmanTracksSettings settings) {
    inPixels = !settings.road().mapToRoad();
    allowed = inPixels && settings.things().together();
    apartTogetherUs = settings.clusters().merging().seenApartUs();
  }

  void reset() {
    standing.clear();
  }

  /** Takes a newborn track, which is a part of what it is in touch with. */
  void begin(Track born, Measurement measurement, EventBatch batch, long timeUs) {
    born.nowXPx = measurement.x;
    born.nowYPx = measurement.y;
    born.part.begin(batch);
    standing.begin(born, timeUs);
    if (!allowed) {
      return;
    }
    for (int i = 0; i < tracks.count(); i++) {
      Track other = tracks.get(i);
      int whole = thingOf(other);
      if (other != born
          && whole > 0
          && (touch(born, other)
              || isWithin(born, other)
              || isBeside(born, other, timeUs) && !isWhereOneWasLost(born, other))) {
        born.part.wholeId = whole;
        born.part.touchedUs = timeUs;
        return;
      }
    }
  }

  /** Looks at who is in touch with whom at a step. */
  void step(long timeUs) {
    if (allowed) {
      gather(timeUs);
    }
    if (inPixels) {
      standing.step(tracks, timeUs);
    }
  }

  private void gather(long timeUs) {
    boolean some = false;
    for (int i = 0; i < tracks.count(); i++) {
      Track track = tracks.get(i);
      track.part.reached = track.id > 0 && track.batch != null;
      if (track.part.wholeId > 0) {
        some = true;
        succeed(track);
      }
    }
    for (int i = 0; some && i < tracks.count(); i++) {
      showSure(tracks.get(i), timeUs);
    }
    if (some) {
      reach(timeUs);
      part(timeUs);
      count();
      measure();
    }
    join(timeUs);
  }

  /** Lets the best part of a thing go on with its identity if the track that has it is blind. */
  private void succeed(Track part) {
    Track whole = find(part.part.wholeId);
    if (whole != null && whole.batch == null) {
      passOn(whole);
    } else if (whole == null && part.batch != null) {
      part.id = part.part.wholeId;
      part.part.wholeId = 0;
      part.part.reached = true;
    }
  }

  /**
   * Lets the best part of a thing go on with its identity instead of the track that has it.
   *
   * @return whether there is one
   */
  boolean passOn(Track whole) {
    return passOn(whole, false);
  }

  private boolean passOn(Track whole, boolean toSure) {
    Track best = null;
    for (int i = 0; i < tracks.count(); i++) {
      Track other = tracks.get(i);
      boolean isPart = whole.id > 0 && other.part.wholeId == whole.id && other.batch != null;
      if (isPart
          && (best == null || other.events > best.events)
          && (!toSure || TrackReports.isSure(other))) {
        best = other;
      }
    }
    if (best == null) {
      return false;
    }
    best.events = whole.events;
    best.part.extent.take(whole.part.extent, whole, best);
    best.id = whole.id;
    best.part.wholeId = 0;
    best.part.reached = true;
    best.part.unsureSteps = 0;
    whole.id = 0;
    return true;
  }

  /** Shows a thing where its place is known, if that of the track that is shown is not. */
  private void showSure(Track whole, long timeUs) {
    if (whole.id == 0 || whole.batch == null || TrackReports.isSure(whole)) {
      whole.part.unsureSteps = 0;
      return;
    }
    int id = whole.id;
    if (++whole.part.unsureSteps >= UNSURE_STEPS && passOn(whole, true)) {
      whole.part.wholeId = id;
      whole.part.touchedUs = timeUs;
      whole.part.countedEvents = whole.events;
    }
  }

  private Track find(int id) {
    for (int i = 0; i < tracks.count(); i++) {
      if (tracks.get(i).id == id) {
        return tracks.get(i);
      }
    }
    return null;
  }

  /** Finds those that are in touch with a thing, by way of its parts, or where it is. */
  private void reach(long timeUs) {
    boolean more = true;
    while (more) {
      more = false;
      for (int i = 0; i < tracks.count(); i++) {
        Track part = tracks.get(i);
        if (part.part.wholeId == 0 || part.part.reached) {
          continue;
        }
        Track by = reachedBy(part);
        if (by != null) {
          part.part.reached = true;
          part.part.touchedUs = timeUs;
          part.part.wholeId = thingOf(by);
          more = true;
        }
      }
    }
  }

  /** What is reached already and in touch, of the same thing if there is such; or null. */
  private Track reachedBy(Track part) {
    Track found = null;
    for (int i = 0; i < tracks.count(); i++) {
      Track other = tracks.get(i);
      if (other.part.reached && touch(part, other)) {
        found = other;
        if (thingOf(other) == part.part.wholeId) {
          return other;
        }
      }
    }
    return found;
  }

  /** Gives those that are apart, or round, an identity of their own. */
  private void part(long timeUs) {
    for (int i = 0; i < tracks.count(); i++) {
      Track part = tracks.get(i);
      if (part.part.wholeId > 0
          && (part.part.isRound() || !part.part.reached && isApart(part, timeUs))) {
        part.part.wholeId = 0;
        part.id = tracks.nextId();
        part.part.reached = true;
        reach(timeUs);
      }
    }
  }

  /** Whether a part that is not in touch has been apart from its thing for long enough. */
  private boolean isApart(Track part, long timeUs) {
    Track whole = find(part.part.wholeId);
    boolean isWhere = whole != null && isWithin(part, whole);
    if (whole != null
        && (isWhere || TrackPart.areNear(part, whole, TOGETHER_RADII))
        && !TrackPart.moveApart(part, whole)) {
      isWhere = true;
      if (TrackPart.isMoving(part) && TrackPart.isMoving(whole)) {
        part.part.touchedUs = timeUs;
      }
    }
    return timeUs - part.part.touchedUs >= (isWhere ? WITHIN_US : APART_US);
  }

  /** Whether a newborn track may be another edge of the thing that an edge is of. */
  private static boolean isBeside(Track born, Track other, long timeUs) {
    boolean isPiece = other.part.isEdge() || other.id == 0 || other.part.extent.radiusPx() > 0;
    return isPiece
        && (timeUs - other.bornUs < APPEARING_US || TrackPart.isMoving(other))
        && TrackPart.areNear(born, other, BESIDE_RADII);
  }

  /** Whether what is born is where another thing is expected that has lost its cluster. */
  private boolean isWhereOneWasLost(Track born, Track other) {
    for (int i = 0; i < tracks.count(); i++) {
      Track lost = tracks.get(i);
      double reach = TOUCHING_RADII * (born.radiusPx + lost.radiusPx);
      if (lost != other
          && lost.id > 0
          && lost.batch == null
          && Math.hypot(lost.nowXPx - born.nowXPx, lost.nowYPx - born.nowYPx) < reach) {
        return true;
      }
    }
    return false;
  }

  /** Events of parts are the thing's. */
  private void count() {
    for (int i = 0; i < tracks.count(); i++) {
      Track part = tracks.get(i);
      if (part.part.wholeId > 0) {
        Track whole = find(part.part.wholeId);
        if (whole != null) {
          whole.events += part.events - part.part.countedEvents;
        }
        part.part.countedEvents = part.events;
      }
    }
  }

  /** Measures how far things reach. */
  private void measure() {
    for (int i = 0; i < tracks.count(); i++) {
      Track whole = tracks.get(i);
      if (whole.id == 0 || whole.batch == null) {
        continue;
      }
      boolean some = false;
      whole.part.extent.start();
      whole.part.extent.add(whole, whole);
      for (int j = 0; j < tracks.count(); j++) {
        if (tracks.get(j).part.wholeId == whole.id && tracks.get(j).part.reached) {
          whole.part.extent.add(whole, tracks.get(j));
          some = true;
        }
      }
      if (!some && whole.part.extent.radiusPx() < whole.radiusPx) {
        whole.part.extent.clear();
        continue;
      }
      whole.part.extent.settle();
      whole.part.extent.cover(whole, whole);
      for (int j = 0; j < tracks.count(); j++) {
        if (tracks.get(j).part.wholeId == whole.id && tracks.get(j).part.reached) {
          whole.part.extent.cover(whole, tracks.get(j));
        }
      }
    }
  }

  /** Makes one of two things that have been in touch for long. */
  private void join(long timeUs) {
    for (int i = 0; i < tracks.count(); i++) {
      Track track = tracks.get(i);
      if (track.id == 0 || track.batch == null || track.part.isRound()) {
        track.part.besideId = 0;
        continue;
      }
      Track beside = beside(track);
      if (beside == null) {
        track.part.besideId = 0;
        continue;
      }
      int besideId = thingOf(beside);
      if (besideId != track.part.besideId) {
        track.part.besideId = besideId;
        track.part.besideSinceUs = timeUs;
        track.part.beside = null;
      }
      double dx = beside.nowXPx - track.nowXPx;
      double dy = beside.nowYPx - track.nowYPx;
      double movedX = dx - track.part.besideXPx;
      double movedY = dy - track.part.besideYPx;
      double most = QUIET_RADII * (track.radiusPx + beside.radiusPx);
      if (beside != track.part.beside || movedX * movedX + movedY * movedY > most * most) {
        track.part.beside = beside;
        track.part.besideXPx = dx;
        track.part.besideYPx = dy;
        track.part.quietSinceUs = timeUs;
      }
      boolean two = track.wasAlone() && beside.wasAlone();
      if (timeUs - track.part.besideSinceUs >= apartTogetherUs
          || !two && timeUs - track.part.quietSinceUs >= QUIET_US) {
        becomePart(track, besideId, timeUs);
      }
    }
  }

  /** The older thing, or part of it, that a track is in touch with; the one of before if it is. */
  private Track beside(Track track) {
    Track found = null;
    for (int j = 0; j < tracks.count(); j++) {
      Track other = tracks.get(j);
      int id = thingOf(other);
      if (id > 0
          && id < track.id
          && (touch(track, other) || !track.wasAlone() && isWithin(track, other))) {
        if (other == track.part.beside) {
          return other;
        }
        found = found == null ? other : found;
      }
    }
    return found;
  }

  private void becomePart(Track track, int wholeId, long timeUs) {
    for (int i = 0; i < tracks.count(); i++) {
      if (tracks.get(i).part.wholeId == track.id) {
        tracks.get(i).part.wholeId = wholeId;
      }
    }
    tracks.end(track);
    track.part.wholeId = wholeId;
    track.part.touchedUs = timeUs;
    track.part.countedEvents = track.events;
  }

  /** Whether a track is where a thing with parts is. */
  private static boolean isWithin(Track track, Track whole) {
    return whole.id > 0
        && whole.batch != null
        && track.batch != null
        && !track.part.isRound()
        && whole.part.extent.distance(whole, track.nowXPx, track.nowYPx)
            < whole.part.extent.radiusPx();
  }

  /** Identity of the thing that a track is or is a part of, or 0. */
  private static int thingOf(Track track) {
    return track.id > 0 ? track.id : track.part.wholeId;
  }

  private static boolean touch(Track a, Track b) {
    int thing = thingOf(a);
    return TrackPart.areNear(
        a, b, thing > 0 && thing == thingOf(b) ? HOLDING_RADII : TOUCHING_RADII);
  }
}
