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
  }

  /** Begins with a measurement. */
  void begin(EventBatch batch) {
    roundShare = batch.isRound() ? 1 : 0;
    learnForm(batch);
    bornFormX = formX;
    bornFormY = formY;
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
}
