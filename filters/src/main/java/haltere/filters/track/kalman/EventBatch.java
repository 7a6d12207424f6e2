package haltere.filters.track.kalman;

import haltere.filters.cluster.ClusterReadings;

/**
 * The events of one cluster since its track was last updated: their number, and, once it is
 * measured, their mean place, mean time, scatter and outline. Thread rule: that of its owner.
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

  int clusterId;
  boolean seen;

  /** Index in the present readings. */
  int index;

  /** When it was last measured, or when its cluster began. */
  long sinceUs;

  /** Events since then; a cluster may have a share of an event only. */
  double events;

  double radiusPx;

  /** Whether its cluster has just turned out to be one of two, and is elsewhere. */
  boolean parted;

  /** The track that has it, or null. */
  Track track;

  // What the cluster says of those events.

  /** Variance of the place of its middle that does not fall with the number of events. */
  double unseenVariance;

  /** The same of the middle of its outline. */
  double outlineMisfitVariance;

  /** Mean time of the events, whole microseconds. */
  long meanTimeUs;

  double meanX;
  double meanY;

  /** Covariance of the place of one event. */
  double varianceX;

  double covarianceXy;
  double varianceY;

  /** Direction of the line along which its cluster's place is not known, or 0. */
  private double lineX;

  private double lineY;

  // Information on the centre of a round outline, and that times the centre.
  private double outlineXx;
  private double outlineXy;
  private double outlineYy;
  private double outlineX;
  private double outlineY;

  void begin(int id, long timeUs) {
    clusterId = id;
    track = null;
    clear(timeUs);
  }

  void clear(long timeUs) {
    sinceUs = timeUs;
    events = 0;
    parted = false;
  }

  /** Sees its cluster, and how many events that has by now. */
  void see(ClusterReadings readings, int newIndex) {
    index = newIndex;
    seen = true;
    radiusPx = readings.radiusPx(index);
    events = readings.newEvents(index);
  }

  /** Takes what the cluster says of its events, of which there are some; later ones are new. */
  void measure(long timeUs, ClusterReadings readings) {
    readings.measure(index);
    unseenVariance = readings.unseenVariance(index);
    outlineMisfitVariance = readings.outlineMisfitVariance(index);
    lineX = readings.lineX(index);
    lineY = readings.lineY(index);
    meanTimeUs = Math.round(timeUs - readings.measuredAgeUs(index));
    meanX = readings.measuredX(index);
    meanY = readings.measuredY(index);
    varianceX = readings.eventVarianceX(index);
    covarianceXy = readings.eventCovarianceXy(index);
    varianceY = readings.eventVarianceY(index);
    outlineXx = readings.outlineXx(index);
    outlineXy = readings.outlineXy(index);
    outlineYy = readings.outlineYy(index);
    outlineX = readings.outlineX(index);
    outlineY = readings.outlineY(index);
  }

  /** Whether the outline tells the centre better than the mean of the events does. */
  boolean hasOutline() {
    double determinant = outlineXx * outlineYy - outlineXy * outlineXy;
    return determinant > 0
        && (outlineXx + outlineYy) / determinant
            < (varianceX + varianceY) / events + 2 * unseenVariance;
  }

  /** Whether that outline is round: of a part of a large ring it is known in one direction only. */
  boolean isRound() {
    double trace = outlineXx + outlineYy;
    return outlineXx * outlineYy - outlineXy * outlineXy > LEAST_ROUND * trace * trace
        && surroundsCentre();
  }

  /** Whether its events are all around the middle, and not at a corner or on one side. */
  private boolean surroundsCentre() {
    double dx = meanX - outlineCentreX();
    double dy = meanY - outlineCentreY();
    double off = dx * dx + dy * dy;
    return off < MOST_ONE_SIDED * (off + varianceX + varianceY);
  }

  double outlineVarianceX() {
    return outlineYy / determinant();
  }

  double outlineCovarianceXy() {
    return -outlineXy / determinant();
  }

  double outlineVarianceY() {
    return outlineXx / determinant();
  }

  double outlineCentreX() {
    return (outlineYy * outlineX - outlineXy * outlineY) / determinant();
  }

  double outlineCentreY() {
    return (outlineXx * outlineY - outlineXy * outlineX) / determinant();
  }

  private double determinant() {
    return outlineXx * outlineYy - outlineXy * outlineXy;
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
    return lineX * lineX * varianceX + 2 * lineX * lineY * covarianceXy + lineY * lineY * varianceY;
  }

  /** Standard deviation of an event about the centre, both axes taken together. */
  double spreadPx() {
    return Math.sqrt((varianceX + varianceY) / 2);
  }
}
