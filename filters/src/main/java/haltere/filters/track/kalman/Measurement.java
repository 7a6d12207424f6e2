package haltere.filters.track.kalman;

import haltere.filters.cluster.ClusterReadings;
import haltere.filters.track.MeasurementSettings;
import haltere.filters.track.MeasurementSource;
import haltere.filters.track.motion.MotionModes;

/**
 * One measurement of a place in pixels, made of what a cluster has gathered. Thread rule: that of
 * its owner.
 */
final class Measurement {
  /** Squared errors of outlines over what the scatter of their events says. */
  private static final double OUTLINE_SHARE = 0.95;

  /** Of two outlines in one place a part of the events is of the other. */
  private static final double CONTESTED_FACTOR = 4;

  /** How many times as unsure as one event the middle of events of two things is. */
  private static final double SWOLLEN_FACTOR = 10;

  private final MeasurementSettings settings;
  private final boolean outlines;
  long timeUs;
  double x;
  double y;
  double xx;
  double xy;
  double yy;
  boolean ofOutline;

  /** Of round things, or on a road, where there are none: vehicles are boxes that grow. */
  Measurement(MeasurementSettings settings, boolean onRoad) {
    this.settings = settings;
    outlines = settings.source() == MeasurementSource.OUTLINE && !onRoad;
  }

  /** What a batch says to a track, or to nobody yet. */
  void of(EventBatch batch, Track track, ClusterReadings readings, long nowUs) {
    boolean swollen = track != null && batch.track == track && track.part.isSwollen();
    ofOutline = outlines && batch.hasOutline() && !swollen;
    if (settings.source() == MeasurementSource.CENTRE) {
      timeUs = nowUs;
      x = readings.x(batch.index);
      y = readings.y(batch.index);
      // From a hundredth of its end at first to its end.
      double variance =
          settings.maxMeasurementVariance()
              * (track == null
                  ? settings.dynamicVariances() ? 0.01 : 1
                  : 1 - 0.99 * track.youth(nowUs));
      xx = variance;
      yy = variance;
      xy = 0;
      return;
    }
    timeUs = batch.meanTimeUs();
    if (ofOutline) {
      double more =
          OUTLINE_SHARE
              * settings.varianceFactor()
              * (track != null && track.contested ? CONTESTED_FACTOR : 1);
      x = batch.outlineCentreX();
      y = batch.outlineCentreY();
      xx = more * batch.outlineVarianceX() + batch.outlineMisfitVariance;
      xy = more * batch.outlineCovarianceXy();
      yy = more * batch.outlineVarianceY() + batch.outlineMisfitVariance;
      return;
    }
    x = batch.meanX();
    y = batch.meanY();
    // Of two tracks in one place each event may be the other's: as good as one event. What another
    // thing has run into is off for as long as that lasts.
    boolean mixed = track != null && track.contested;
    double share = swollen ? SWOLLEN_FACTOR : mixed ? 1 : settings.varianceFactor() / batch.events;
    double floor = settings.floorPx() * settings.floorPx() + batch.unseenVariance;
    xx = batch.varianceX() * share + batch.lineVarianceX() + floor;
    yy = batch.varianceY() * share + batch.lineVarianceY() + floor;
    xy = batch.covarianceXy() * share + batch.lineCovarianceXy();
  }

  /** Maps it to the plane of the tracks; false if it is not on it. */
  boolean map(MeasurementPlane plane) {
    return plane.map(x, y, xx, xy, yy);
  }

  /** The same where a track is expected at a place. */
  boolean map(MeasurementPlane plane, MotionModes expected) {
    return plane.map(expected, x, y, xx, xy, yy);
  }
}
