package haltere.filters.track.kalman;

import haltere.filters.cluster.ClusterReadings;

/**
 * The events of one cluster since its track was last updated: their number, mean place, mean time
 * and scatter. Thread rule: that of its owner.
 */
final class EventBatch {
  /**
   * Determinant over the squared trace of the information on the middle of what is round: 0.22 of a
   * disc, 0.25 at most.
   */
  private static final double LEAST_ROUND = 0.17;

  /**
   * How far the mean of the events may be from that middle, as a share of their distance from it,
   * squared: 0.4 of half a ring, 0.5 of two sides of a square, 0 of a whole ring.
   */
  private static final double MOST_ONE_SIDED = 0.2;

  private static final double US = 1e-6;

  int clusterId;
  boolean seen;

  /** Index in the present readings. */
  int index;

  /** Since when it collects. */
  long sinceUs;

  /** A cluster may have a share of an event only. */
  double events;

  double radiusPx;

  /** Whether its cluster has just turned out to be one of two, and is elsewhere. */
  boolean parted;

  /** Variance of the place of its middle that does not fall with the number of events. */
  double unseenVariance;

  /** The same of the middle of its outline. */
  double outlineMisfitVariance;

  /** Direction of the line along which its cluster's place is not known, or 0. */
  private double lineX;

  private double lineY;
  private double sumX;
  private double sumY;
  private double sumAgeUs;
  private double sumXx;
  private double sumXy;
  private double sumYy;
  private long baseUs;

  // Information on the centre of a round outline, and that times the centre when the batch began.
  // One reading knows the centre best in one direction and the next one, where the thing has gone
  // on to, in another: to be put together they have to be of one time.
  private double outlineXx;
  private double outlineXy;
  private double outlineYy;
  private double outlineX;
  private double outlineY;

  /** One over the determinant of that information. */
  private double perOutline;

  /** One over the number of events. */
  private double perEvent;

  /** Velocity of the cluster at the last reading that had an outline, pixels a second. */
  private double vx;

  private double vy;

  /** The track that has it, or null. */
  Track track;

  void begin(int id, long timeUs) {
    clusterId = id;
    track = null;
    clear(timeUs);
  }

  void clear(long timeUs) {
    sinceUs = timeUs;
    events = 0;
    sumX = 0;
    sumY = 0;
    sumAgeUs = 0;
    sumXx = 0;
    sumXy = 0;
    sumYy = 0;
    baseUs = timeUs;
    parted = false;
    outlineXx = 0;
    outlineXy = 0;
    outlineYy = 0;
    outlineX = 0;
    outlineY = 0;
  }

  void add(long timeUs, ClusterReadings readings, int i) {
    index = i;
    seen = true;
    radiusPx = readings.radiusPx(i);
    unseenVariance = readings.unseenVariance(i);
    outlineMisfitVariance = readings.outlineMisfitVariance(i);
    lineX = readings.lineX(i);
    lineY = readings.lineY(i);
    double n = readings.newEvents(i);
    if (!(n > 0)) {
      return;
    }
    events += n;
    perEvent = 1 / events;
    double meanUs = timeUs - readings.measuredAgeUs(i) - baseUs;
    sumX += n * readings.measuredX(i);
    sumY += n * readings.measuredY(i);
    sumAgeUs += n * meanUs;
    sumXx += n * readings.eventVarianceX(i);
    sumXy += n * readings.eventCovarianceXy(i);
    sumYy += n * readings.eventVarianceY(i);
    double informationXx = readings.outlineXx(i);
    if (informationXx > 0) {
      double informationXy = readings.outlineXy(i);
      double informationYy = readings.outlineYy(i);
      vx = readings.vx(i);
      vy = readings.vy(i);
      double wayX = US * meanUs * vx;
      double wayY = US * meanUs * vy;
      outlineXx += informationXx;
      outlineXy += informationXy;
      outlineYy += informationYy;
      outlineX += readings.outlineX(i) - informationXx * wayX - informationXy * wayY;
      outlineY += readings.outlineY(i) - informationXy * wayX - informationYy * wayY;
      perOutline = 1 / (outlineXx * outlineYy - outlineXy * outlineXy);
    }
  }

  double meanX() {
    return sumX * perEvent;
  }

  double meanY() {
    return sumY * perEvent;
  }

  /** Mean time of the events, whole microseconds. */
  long meanTimeUs() {
    return baseUs + Math.round(sumAgeUs * perEvent);
  }

  /** How long after the beginning of the batch the mean of its events is, seconds. */
  private double meanAfterS() {
    return US * sumAgeUs * perEvent;
  }

  /** Variance of the column of one event. */
  double varianceX() {
    return sumXx * perEvent;
  }

  double covarianceXy() {
    return sumXy * perEvent;
  }

  double varianceY() {
    return sumYy * perEvent;
  }

  /** Whether the outline tells the centre better than the mean of the events does. */
  boolean hasOutline() {
    return outlineXx > 0
        && perOutline > 0
        && (outlineXx + outlineYy) * perOutline
            < (sumXx + sumYy) * perEvent * perEvent + 2 * unseenVariance;
  }

  /** Whether that outline is round: of a part of a large ring it is known in one direction only. */
  boolean isRound() {
    double trace = outlineXx + outlineYy;
    return outlineXx * outlineYy - outlineXy * outlineXy > LEAST_ROUND * trace * trace
        && surroundsCentre();
  }

  /** Whether its events are all around the middle, and not at a corner or on one side. */
  private boolean surroundsCentre() {
    double dx = meanX() - outlineCentreX();
    double dy = meanY() - outlineCentreY();
    double off = dx * dx + dy * dy;
    return off < MOST_ONE_SIDED * (off + varianceX() + varianceY());
  }

  double outlineVarianceX() {
    return outlineYy * perOutline;
  }

  double outlineCovarianceXy() {
    return -outlineXy * perOutline;
  }

  double outlineVarianceY() {
    return outlineXx * perOutline;
  }

  double outlineCentreX() {
    return (outlineYy * outlineX - outlineXy * outlineY) * perOutline + vx * meanAfterS();
  }

  double outlineCentreY() {
    return (outlineXx * outlineY - outlineXy * outlineX) * perOutline + vy * meanAfterS();
  }

  /** What the place along a line is uncertain by, as the variance of one event along it. */
  double lineVarianceX() {
    return lineX * lineX * lineVariance();
  }

  double lineCovarianceXy() {
    return lineX * lineY * lineVariance();
  }

  double lineVarianceY() {
    return lineY * lineY * lineVariance();
  }

  private double lineVariance() {
    return lineX * lineX * varianceX()
        + 2 * lineX * lineY * covarianceXy()
        + lineY * lineY * varianceY();
  }

  /** Standard deviation of an event about the centre, both axes taken together. */
  double spreadPx() {
    return Math.sqrt((varianceX() + varianceY()) / 2);
  }
}
