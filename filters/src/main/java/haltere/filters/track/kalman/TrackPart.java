package haltere.filters.track.kalman;

/**
 * What a {@link Track} has to do with others that may be of the same thing, for {@link TrackParts},
 * and whether it has moved, for {@link StandingPlaces}. Thread rule: that of its owner.
 */
final class TrackPart {
  /** With so large a share of its measurements round outlines, a track is a round thing. */
  private static final double ROUND = 0.5;

  /** What is long in one direction and then across it changes by up to 2. */
  private static final double TURNED = 0.5;

  /** Share by which a measurement changes that. */
  private static final double ROUND_GAIN = 0.1;

  /** What is longer than this has the form of an edge. */
  private static final double LONG = 0.6;

  /** Parts of one thing may differ in velocity by this share of it, for things turn and bend. */
  private static final double UNLIKE = 0.5;

  /** Standard deviations by which velocities are known to differ, or to be one. */
  private static final double SIGMAS = 3;

  /** By how many times its events' variance has to become larger for others' to be among them. */
  private static final double SWOLLEN = 1.4;

  /** What is so large for longer has become so. */
  private static final long SWOLLEN_US = 300_000;

  /** Share by which a measurement changes what is the usual variance. */
  private static final double USUAL_GAIN = 0.1;

  /** Identity of the thing that it is a part of, or 0. */
  int wholeId;

  /** How far its parts reach, if it has some. */
  final ThingExtent extent = new ThingExtent();

  /** Of a part, whether it is in touch with the others, and when it last was. */
  boolean reached;

  long touchedUs;

  /** Identity of an older thing that it is beside, or 0, and since when. */
  int besideId;

  long besideSinceUs;

  /** The track by which it is beside that, where that was from here, and since when about so. */
  Track beside;

  double besideXPx;
  double besideYPx;
  long quietSinceUs;

  /** For how many steps its place was not known well enough to be shown. */
  int unsureSteps;

  /** Of a part, how many of its events the thing has been told of. */
  double countedEvents;

  /** Which share of its measurements are round outlines. */
  private double roundShare;

  /** Elongation at twice the angle of the longer axis, 0 to 1: now, and when it began. */
  private double formX;

  private double formY;
  private double bornFormX;
  private double bornFormY;

  /** Where it began, and whether it has moved since. */
  double bornXPx;

  double bornYPx;
  boolean moved;

  /** Whether it is known to stand where it began. */
  boolean isStill;

  /** Variance that its events usually have, both axes together. */
  private double usualVariance;

  private boolean swollen;
  private long swollenSinceUs;

  void clear() {
    wholeId = 0;
    extent.clear();
    besideId = 0;
    beside = null;
    countedEvents = 0;
    unsureSteps = 0;
    roundShare = 0;
    moved = false;
    isStill = false;
    swollen = false;
  }

  /** Begins with a measurement. */
  void begin(EventBatch batch) {
    roundShare = batch.isRound() ? 1 : 0;
    learnForm(batch);
    bornFormX = formX;
    bornFormY = formY;
    usualVariance = batch.varianceX() + batch.varianceY();
  }

  /**
   * Compares the size of its cluster with the usual one.
   *
   * @param known whether that is known, and nothing that is known is in the way
   */
  void compareSize(EventBatch batch, boolean known, long timeUs) {
    double variance = batch.varianceX() + batch.varianceY();
    boolean larger = known && variance > SWOLLEN * usualVariance;
    if (larger && !swollen) {
      swollenSinceUs = timeUs;
    }
    swollen = larger && timeUs - swollenSinceUs < SWOLLEN_US;
    if (larger && !swollen) {
      usualVariance = variance;
    } else if (!larger) {
      usualVariance += USUAL_GAIN * (variance - usualVariance);
    }
  }

  /**
   * Whether its cluster is much larger at once than it was: it has run into what was not seen by
   * itself, such as a thing that enters behind it.
   */
  boolean isSwollen() {
    return swollen;
  }

  /** Learns of a measurement whether it is a round outline, and in which direction it is long. */
  void learn(EventBatch batch) {
    roundShare += ROUND_GAIN * ((batch.isRound() ? 1 : 0) - roundShare);
    learnForm(batch);
  }

  private void learnForm(EventBatch batch) {
    double trace = batch.varianceX() + batch.varianceY();
    formX = (batch.varianceX() - batch.varianceY()) / trace;
    formY = 2 * batch.covarianceXy() / trace;
  }

  /** Whether it has turned, or has another form than when it began. */
  boolean hasTurned() {
    double x = formX - bornFormX;
    double y = formY - bornFormY;
    return x * x + y * y > TURNED * TURNED;
  }

  /** Whether the track has a round outline of its own. */
  boolean isRound() {
    return roundShare > ROUND;
  }

  /** Whether it is an edge, by its form: an edge is always one of something. */
  boolean isEdge() {
    return formX * formX + formY * formY > LONG * LONG;
  }

  /** Whether two that are not round are within so many of their radii. */
  static boolean areNear(Track a, Track b, double radii) {
    double reach = radii * (a.radiusPx + b.radiusPx);
    double dx = a.nowXPx - b.nowXPx;
    double dy = a.nowYPx - b.nowYPx;
    boolean both =
        a != b && a.batch != null && b.batch != null && !a.part.isRound() && !b.part.isRound();
    return both && dx * dx + dy * dy < reach * reach;
  }

  /** Whether a track is known to move: by its radius in a second, at least. */
  static boolean isMoving(Track track) {
    double squared = track.nowVxPxS * track.nowVxPxS + track.nowVyPxS * track.nowVyPxS;
    return squared > SIGMAS * SIGMAS * (track.varianceVxPx2S2() + track.varianceVyPx2S2())
        && squared > track.radiusPx * track.radiusPx;
  }

  /**
   * Whether two tracks are known to move too differently to be parts of one thing. How an edge
   * moves along itself nobody knows, and so two edges across each other never are.
   */
  static boolean moveApart(Track a, Track b) {
    double dx = a.nowVxPxS - b.nowVxPxS;
    double dy = a.nowVyPxS - b.nowVyPxS;
    double seen =
        a.part.isEdge()
            ? a.part.across(dx, dy) * (b.part.isEdge() ? a.part.parallel(b.part) : 1)
            : b.part.across(dx, dy);
    double unsure =
        a.varianceVxPx2S2() + a.varianceVyPx2S2() + b.varianceVxPx2S2() + b.varianceVyPx2S2();
    double least = UNLIKE * Math.max(a.speedPxS(), b.speedPxS()) + SIGMAS * Math.sqrt(0.5 * unsure);
    return seen > least * least;
  }

  /** Square of a vector, or of what is across the edge of it, if this is one. */
  private double across(double dx, double dy) {
    double squared = dx * dx + dy * dy;
    if (!isEdge()) {
      return squared;
    }
    double turned = formX * (dx * dx - dy * dy) + 2 * formY * dx * dy;
    return 0.5 * (squared - turned / elongation());
  }

  /** Square of the cosine of the angle between two edges. */
  private double parallel(TrackPart other) {
    double both = elongation() * other.elongation();
    return 0.5 * (1 + (formX * other.formX + formY * other.formY) / both);
  }

  private double elongation() {
    return Math.sqrt(formX * formX + formY * formY);
  }
}
