package haltere.filters.track.kalman;

import haltere.filters.track.MeasurementSettings;
import haltere.filters.track.TrackUpdate;
import haltere.filters.track.motion.CombinedInnovation;
import haltere.filters.track.motion.MotionModes;
import haltere.filters.track.motion.MotionNoise;
import haltere.filters.track.road.FoundLine;

/**
 * One track: its filter, what it holds on to and since when. Its bookkeeping is that of {@link
 * TrackEstimator}.
 *
 * <p>Thread rule: that of its owner.
 */
final class Track {
  private static final double US = 1e-6;

  /** Within this time a track that has lost its events has stopped, if it has. */
  private static final double REST_S = 0.05;

  /** Squared difference of two velocities that are unlike, over the product of the speeds. */
  private static final double UNLIKE = 0.01;

  private static final double UNLIKE_SIGMAS = 4;
  private static final int ALONE_UPDATES = 50;
  private static final int LEAST_FREE_UPDATES = 10;
  private static final int SETTLED_UPDATES = 20;

  /** A velocity of fewer updates than this is not kept where a track is found elsewhere. */
  private static final int TRUSTED_UPDATES = 10;

  MotionModes motion;
  private MotionModes later;
  private final Comparison compared;
  private final MeasurementPlane plane;
  private final MeasurementSettings settings;

  /** 0 until it is shown. */
  int id;

  /** Its number among all that there were, which is never that of another and never 0. */
  int serial;

  long bornUs;

  /** Time of the state. */
  long stateUs;

  /** When it last got a measurement, by the clock of the steps. */
  long heardUs;

  int updates;

  /** How many updates there had been when it was last found elsewhere than expected. */
  private int displacedAt;

  /** Updates while no other track was in the way. */
  private int freeUpdates;

  int gatedInARow;
  double events;

  /** The cluster that it has, or null while it coasts. */
  EventBatch batch;

  double radiusPx;

  /** Standard deviation of an event of its own about its centre. */
  double spreadPx;

  /** Whether another track is so near that events may be the other's. */
  boolean contested;

  /** Until when that lasts at least. */
  private long contestedUntilUs;

  /** Whether another track is so near that which is which may be in question. */
  boolean nearOther;

  /** Whether one of these moves differently. */
  boolean nearUnlike;

  /** Whether it lost its cluster to another track, not in the open. */
  boolean hidden;

  /** Where it was in pixels when it lost its cluster. */
  double lostXPx;

  double lostYPx;

  /** Where it is at the time of the step, in pixels, and whether that is in the picture. */
  double nowXPx;

  double nowYPx;
  double nowVxPxS;
  double nowVyPxS;
  private double varianceVxPx2S2;
  private double varianceVyPx2S2;

  /** Whether these were worked out since it has last looked where it is. */
  private boolean knowsVelocitySpread;

  boolean inView;

  /** Where it is among the counting lines. */
  final LineSides sides = new LineSides();

  /** The edge of a vehicle that it follows. */
  final RoadLine line = new RoadLine();

  /** What it has to do with others that may be of the same thing. */
  final TrackPart part = new TrackPart();

  /** Of a vehicle, until when it is shown. */
  long shownUntilUs;

  /** Whether it is a vehicle that has stopped. */
  boolean stands;

  Track(
      MotionNoise noise,
      MeasurementPlane plane,
      MeasurementSettings settings,
      Comparison compared) {
    this.plane = plane;
    this.compared = compared;
    this.settings = settings;
    motion = new MotionModes(noise);
    later = new MotionModes(noise);
  }

  /** Begins with the measurement that the plane has mapped. */
  void launch(long timeUs, long stepUs) {
    begin(timeUs, stepUs);
    motion.launch(plane.x, plane.y, plane.xx, plane.xy, plane.yy);
  }

  private void begin(long timeUs, long stepUs) {
    id = 0;
    bornUs = timeUs;
    stateUs = timeUs;
    heardUs = stepUs;
    updates = 1;
    line.grounding.begin(false);
    freeUpdates = 0;
    displacedAt = 0;
    gatedInARow = 0;
    events = 0;
    batch = null;
    contested = false;
    contestedUntilUs = Long.MIN_VALUE;
    nearOther = false;
    nearUnlike = false;
    hidden = false;
    shownUntilUs = Long.MIN_VALUE;
    stands = false;
    part.clear();
    sides.clear();
  }

  /** Begins with a line that was found, whose speed is known. */
  void launchLine(FoundLine found, long stepUs) {
    begin(stepUs, stepUs);
    found.launch(motion);
  }

  /** Takes over the identity of another track of the same thing, if that has the older one. */
  void nameAfter(Track other) {
    sides.join(other.sides, other.bornUs < bornUs, motion.vy() > 0 ? 1 : -1);
    if (other.id > 0 && (id == 0 || other.bornUs < bornUs)) {
      int own = id;
      id = other.id;
      other.id = own;
      bornUs = other.bornUs;
    }
  }

  /** Goes on with a line that was found, as the same track. */
  void moveOn(FoundLine found, long stepUs) {
    stateUs = stepUs;
    heardUs = stepUs;
    gatedInARow = 0;
    found.launch(motion);
  }

  /** Goes on with another line of the vehicle that was found, with the speed that it has. */
  void rejoin(FoundLine found, long stepUs) {
    MotionModes now = at(stepUs);
    later = motion;
    motion = now;
    stateUs = stepUs;
    heardUs = stepUs;
    gatedInARow = 0;
    found.rejoin(motion);
  }

  /** Takes in what {@link #compare} has compared, which was not heard but silence. */
  void rest(long timeUs) {
    correct();
    stateUs = Math.max(stateUs, timeUs);
    gatedInARow = 0;
  }

  /** Begins again where the plane has mapped a measurement to, as the same track. */
  void relaunch(long timeUs, long stepUs) {
    stateUs = timeUs;
    heardUs = stepUs;
    gatedInARow = 0;
    motion.relaunch(plane.x, plane.y, plane.xx, plane.xy, plane.yy);
  }

  /** Begins again where its own cluster is for some time, though it was expected elsewhere. */
  void follow(long timeUs, long stepUs) {
    stateUs = timeUs;
    heardUs = stepUs;
    gatedInARow = 0;
    if (updates - displacedAt < TRUSTED_UPDATES) {
      motion.launch(plane.x, plane.y, plane.xx, plane.xy, plane.yy);
    } else {
      motion.displace(plane.x, plane.y, plane.xx, plane.xy, plane.yy);
    }
    displacedAt = updates;
  }

  /** Holds on to a cluster. */
  void hold(EventBatch held) {
    batch = held;
    hidden = false;
    held.track = this;
  }

  /** Lets go of its cluster, if it has one; hidden if another track is in the way. */
  void release(boolean isHidden) {
    if (batch != null) {
      batch.track = null;
      batch = null;
      hidden = isHidden && wasFree();
      lostXPx = nowXPx;
      lostYPx = nowYPx;
    }
  }

  /** Whether it has been seen by itself: what has not may be a part of another. */
  boolean wasFree() {
    return freeUpdates >= LEAST_FREE_UPDATES && (part.isRound() || wasAlone());
  }

  /** Whether it is known how large its cluster is by itself. */
  boolean isSettled() {
    return updates >= SETTLED_UPDATES && part.isRound() && !contested;
  }

  /** Whether it has been by itself for so long that it is a thing and no part of one. */
  boolean wasAlone() {
    return freeUpdates >= ALONE_UPDATES;
  }

  /** Whether it goes on as predicted, for nothing is seen of it. */
  boolean isUnseen(long timeUs) {
    boolean isVehicle = shownUntilUs > Long.MIN_VALUE;
    return isVehicle
        ? !stands && timeUs - heardUs > TrackReports.SHOWN_WITHOUT_CLUSTER_US
        : batch == null;
  }

  /** Stays contested for a time after another track was so near. */
  void keepContested(long timeUs, long lastingUs) {
    if (contested) {
      contestedUntilUs = timeUs + lastingUs;
    }
    contested |= nearOther && timeUs < contestedUntilUs;
  }

  double ageS(long timeUs) {
    return (timeUs - bornUs) * US;
  }

  /** How far a variance that changes with the age of a track is from its end: from 1 to 0. */
  double youth(long timeUs) {
    return settings.dynamicVariances() ? Math.exp(-ageS(timeUs) / settings.rampTimeS()) : 0;
  }

  private double noiseFactor(long timeUs) {
    return 1 + 9 * youth(timeUs);
  }

  /** The state at a later time, for a look only. */
  MotionModes at(long timeUs) {
    later.coastFrom(motion, Math.max(0, (timeUs - stateUs) * US), noiseFactor(timeUs));
    return later;
  }

  /**
   * Compares a measurement in pixels with the prediction for its time; the prediction is kept for
   * {@link #take}.
   *
   * @return the normalised innovation squared, NaN if it cannot be compared
   */
  double compare(Measurement measured) {
    double dtS = Math.max(0, (measured.timeUs - stateUs) * US);
    MotionModes ahead = compared.ahead;
    ahead.predictFrom(motion, dtS, noiseFactor(measured.timeUs));
    if (!measured.map(plane, ahead)) {
      return Double.NaN;
    }
    return ahead.innovate(plane.x, plane.y, plane.xx, plane.xy, plane.yy);
  }

  /** Logarithm of the likelihood of what {@link #compare} has compared. */
  double logLikelihood() {
    return compared.ahead.logLikelihood();
  }

  /** Takes in what {@link #compare} has compared. */
  void take(long timeUs, long stepUs) {
    correct();
    stateUs = Math.max(stateUs, timeUs);
    heardUs = stepUs;
    updates++;
    freeUpdates += contested ? 0 : 1;
    gatedInARow = 0;
  }

  private void correct() {
    MotionModes before = motion;
    motion = compared.ahead;
    motion.correct();
    compared.ahead = before;
  }

  /** Works out about where it is in the picture at the time of a step: straight on from here. */
  void look(long timeUs) {
    double dtS = Math.max(0, (timeUs - stateUs) * US);
    inView = plane.toPixels(motion, dtS);
    nowXPx = plane.xPx;
    nowYPx = plane.yPx;
    nowVxPxS = plane.vxPxS;
    nowVyPxS = plane.vyPxS;
    knowsVelocitySpread = false;
  }

  /** Variance of its velocity in pixels along x, as soon as somebody asks for it. */
  double varianceVxPx2S2() {
    findVelocitySpread();
    return varianceVxPx2S2;
  }

  /** The same along y. */
  double varianceVyPx2S2() {
    findVelocitySpread();
    return varianceVyPx2S2;
  }

  private void findVelocitySpread() {
    if (!knowsVelocitySpread && plane.toPixels(motion, 0)) {
      plane.velocitySpread(motion);
      varianceVxPx2S2 = plane.varianceVxPx2S2;
      varianceVyPx2S2 = plane.varianceVyPx2S2;
      knowsVelocitySpread = true;
    }
  }

  /** Whether it is shown and its cluster is among the present readings. */
  boolean hasSeenCluster() {
    return id > 0 && batch != null && batch.seen;
  }

  double speedPxS() {
    return Math.sqrt(squaredSpeed());
  }

  private double squaredSpeed() {
    return nowVxPxS * nowVxPxS + nowVyPxS * nowVyPxS;
  }

  /**
   * Whether it may have stopped where it lost its cluster: in the open nothing vanishes, and what
   * stands makes no events.
   */
  boolean mayRest() {
    return batch == null && !hidden;
  }

  /** How far from where it lost its cluster it may have come to rest. */
  double stoppingPx() {
    return Math.min(speedPxS() * REST_S, 2 * radiusPx);
  }

  /** Whether two tracks are known to move differently. */
  boolean movesUnlike(Track other) {
    double dx = nowVxPxS - other.nowVxPxS;
    double dy = nowVyPxS - other.nowVyPxS;
    double squared = dx * dx + dy * dy;
    if (!(squared * squared > UNLIKE * UNLIKE * squaredSpeed() * other.squaredSpeed())) {
      return false;
    }
    double apart =
        dx * dx / (varianceVxPx2S2() + other.varianceVxPx2S2())
            + dy * dy / (varianceVyPx2S2() + other.varianceVyPx2S2());
    return apart > UNLIKE_SIGMAS * UNLIKE_SIGMAS;
  }

  /** What the last comparison has come to; the gain is that of the likeliest model. */
  TrackUpdate lastUpdate(long timeUs, boolean accepted) {
    MotionModes last = accepted ? motion : compared.ahead;
    CombinedInnovation innovation = last.innovation();
    return new TrackUpdate(
        timeUs,
        id,
        plane.x,
        plane.y,
        innovation.x(),
        innovation.y(),
        innovation.xx(),
        innovation.xy(),
        innovation.yy(),
        innovation.nis(),
        accepted ? last.gain(0, 0) : 0,
        accepted ? last.gain(1, 1) : 0,
        accepted ? last.gain(2, 0) : 0,
        accepted ? last.gain(3, 1) : 0,
        last.x(),
        last.y(),
        last.vx(),
        last.vy(),
        last.covariance(0, 0),
        last.covariance(0, 2),
        last.covariance(2, 2),
        last.covariance(1, 1),
        last.covariance(1, 3),
        last.covariance(3, 3),
        accepted);
  }
}
