package haltere.filters.track;

import haltere.filters.cluster.ClusterReadings;

/**
 * The events of one cluster since its track was last updated: their number, mean place, mean time
 * and scatter. Thread rule: that of its owner.
 */
final class EventBatch {
  int clusterId;
  boolean seen;

  /** Index in the present readings. */
  int index;

  /** Since when it collects. */
  long sinceUs;

  /** A cluster may have a share of an event only. */
  double events;

  double radiusPx;
  boolean overlapped;
  private double sumX;
  private double sumY;
  private double sumAgeUs;
  private double sumXx;
  private double sumXy;
  private double sumYy;
  private long baseUs;

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
  }

  void add(long timeUs, ClusterReadings readings, int i) {
    index = i;
    seen = true;
    radiusPx = readings.radiusPx(i);
    overlapped = readings.overlapped(i);
    double n = readings.newEvents(i);
    if (!(n > 0)) {
      return;
    }
    events += n;
    sumX += n * readings.measuredX(i);
    sumY += n * readings.measuredY(i);
    sumAgeUs += n * (timeUs - readings.measuredAgeUs(i) - baseUs);
    sumXx += n * readings.eventVarianceX(i);
    sumXy += n * readings.eventCovarianceXy(i);
    sumYy += n * readings.eventVarianceY(i);
  }

  double meanX() {
    return sumX / events;
  }

  double meanY() {
    return sumY / events;
  }

  /** Mean time of the events, whole microseconds. */
  long meanTimeUs() {
    return baseUs + Math.round(sumAgeUs / events);
  }

  /** Variance of the column of one event. */
  double varianceX() {
    return sumXx / events;
  }

  double covarianceXy() {
    return sumXy / events;
  }

  double varianceY() {
    return sumYy / events;
  }

  /** Standard deviation of an event about the centre, both axes taken together. */
  double spreadPx() {
    return Math.sqrt((varianceX() + varianceY()) / 2);
  }
}
