package haltere.filters.track.kalman;

import haltere.core.event.SensorGeometry;
import haltere.filters.track.LifeSettings;
import haltere.filters.track.RoadMapping;

/** Which vehicles are gone, and until when the others are shown. Thread rule: that of its owner. */
final class VehicleEnds {
  /** What is slower may stand. */
  static final double STANDING_M_S = 2;

  /** Where a row sees more of the road than this, silence says nothing. */
  private static final double TELLING_M = 3;

  /** Where a row sees more of the road, a vehicle that is followed is too far away. */
  private static final double MOST_ROW_M = 20;

  /** A vehicle that stands is remembered for this many times the usual. */
  private static final double STANDING_FACTOR = 5;

  /** What is not known to be within a vehicle's length, standard deviation, is no longer known. */
  private static final double NOWHERE_M = 5;

  /** What has passed fewer rows has not stopped: it was no vehicle. */
  private static final int SURE_UPDATES = 6;

  private static final double LEAVING_S = 0.15;
  private static final double SHOWN_S = 0.1;
  private static final double ROWS = 3;
  private static final int MOST_GATED = 20;
  private static final double LEAST_ROWS_S = 1e-3;

  private final RoadMapping road;
  private final SensorGeometry sensor;
  private final MeasurementPlane plane;
  private LifeSettings life;

  VehicleEnds(RoadMapping road, SensorGeometry sensor, MeasurementPlane plane) {
    this.road = road;
    this.sensor = sensor;
    this.plane = plane;
  }

  void apply(LifeSettings newLife) {
    life = newLife;
  }

  /** Whether it can be seen that a vehicle stands where a row is worth so many metres. */
  static boolean mayStand(double metresPerRow) {
    return metresPerRow < TELLING_M;
  }

  /** Whether the place that the plane has worked out is well within the picture. */
  static boolean isInPicture(MeasurementPlane plane, SensorGeometry sensor) {
    return plane.yPx > 3 && plane.xPx > 3 && plane.xPx < sensor.width() - 4;
  }

  /** Notes where a vehicle is, how large it is, whether it stands and until when it is shown. */
  void look(Track track, long timeUs) {
    track.look(timeUs);
    double speed = Math.hypot(track.motion.vx(), track.motion.vy());
    track.stands = speed < STANDING_M_S && mayStand(road.distancePerY(plane.yPx));
    double shownS =
        track.stands && hasStopped(track) ? restS() : Math.min(restS(), SHOWN_S + rowsS());
    track.shownUntilUs = track.heardUs + Math.round(shownS * 1e6);
    track.radiusPx = track.line.halfPx();
    track.spreadPx = Math.max(1, track.radiusPx / Math.sqrt(3));
  }

  /** Whether a vehicle is gone of which {@link #look} has just taken note. */
  boolean isOver(Track track, long timeUs) {
    RoadLine line = track.line;
    boolean isAnywhere = track.at(timeUs).covariance(1, 1) > NOWHERE_M * NOWHERE_M;
    boolean isFar = road.distancePerY(plane.yPx) > MOST_ROW_M;
    if (!track.inView || isAnywhere || isFar || plane.yPx + line.extentPx() < -1) {
      return true;
    }
    if (!isInPicture(plane, sensor)) {
      return timeUs - Math.max(track.heardUs, line.bodyUs()) > LEAVING_S * 1e6;
    }
    double mostS =
        !track.stands
            ? Math.min(restS(), life.coastTimeS() + rowsS())
            : hasStopped(track) ? restS() : life.restTimeS();
    return timeUs - track.heardUs > mostS * 1e6 || track.gatedInARow > MOST_GATED;
  }

  /** Whether what stands is a vehicle that has come there, and no line that was none. */
  private static boolean hasStopped(Track track) {
    return track.updates >= SURE_UPDATES && !track.line.grounding.isBeside();
  }

  private double restS() {
    return STANDING_FACTOR * life.restTimeS();
  }

  /** How long it takes to pass some rows. */
  private double rowsS() {
    return ROWS / Math.max(LEAST_ROWS_S, Math.abs(plane.vyPxS));
  }
}
