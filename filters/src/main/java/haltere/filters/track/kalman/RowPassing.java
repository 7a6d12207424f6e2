package haltere.filters.track.kalman;

import haltere.core.event.SensorGeometry;
import haltere.filters.track.KalmanTracksSettings;
import haltere.filters.track.RoadMapping;

/**
 * Measures where the lines of vehicles are: on a row, when enough events say that it passes it; not
 * yet at the next row, when nothing is heard where that should have been passed.
 *
 * <p>Thread rule: that of its owner.
 */
final class RowPassing {
  /**
   * Standard deviation of a row that is passed: a threshold that is reached sooner or later than in
   * other pixels, and the rest of the vehicle.
   */
  private static final double ROW_SD_PX = 0.05;

  private static final double CUT_VARIANCE = 4;

  /**
   * Share of the usual gate, for what passes a row too early is often another line of the same
   * vehicle, and the one that is waited for comes soon.
   */
  private static final double GATE_SHARE = 0.5;

  /** Of a row in which little was seen: it fits or it is something else. */
  private static final double DOUBTFUL_GATE = 4;

  /** Rows by which a line is late until it is held to stand. */
  private static final double LATE_ROWS = 1.75;

  private static final double LATE_VARIANCE = 0.25;
  private static final double REST_VARIANCE = 100;
  private static final long REST_EACH_US = 100_000;

  /** What brakes harder than this has not stopped: its line was lost. */
  private static final double BRAKE_M_S2 = 5;

  private static final double SPEED_ERROR_M_S = 1;

  private final RoadMapping road;
  private final SensorGeometry sensor;
  private final Tracks tracks;
  private final MeasurementPlane plane;
  private final TrackListener listener;
  private KalmanTracksSettings settings;
  private Measurement measurement;
  private double gate;
  private double rowSdPx;

  RowPassing(
      RoadMapping road,
      SensorGeometry sensor,
      Tracks tracks,
      MeasurementPlane plane,
      TrackListener listener) {
    this.road = road;
    this.sensor = sensor;
    this.tracks = tracks;
    this.plane = plane;
    this.listener = listener;
  }

  void apply(KalmanTracksSettings newSettings, double newGate) {
    settings = newSettings;
    gate = GATE_SHARE * newGate;
    measurement = new Measurement(newSettings.measurement(), true);
    rowSdPx = Math.hypot(ROW_SD_PX, newSettings.measurement().floorPx());
  }

  /** Standard deviation of the place of a line when it passes a row. */
  double rowSdPx() {
    return rowSdPx;
  }

  /** Takes in what a step has shown of a vehicle's line. */
  void measure(Track track, long timeUs) {
    RoadLine line = track.line;
    boolean down = line.rowPerS() < 0;
    for (int n = 0; n < RoadLine.ROWS; n++) {
      int k = down ? RoadLine.ROWS - 1 - n : n;
      if (line.isPassed(k)) {
        take(track, k, timeUs);
      }
    }
    waitFor(track, timeUs);
  }

  private void take(Track track, int k, long timeUs) {
    RoadLine line = track.line;
    measurement.timeUs = line.passedUs(k);
    measurement.x = line.column(k);
    measurement.y = line.row(k);
    measurement.xx = line.isCut(k) ? CUT_VARIANCE : line.columnVariance(k);
    measurement.xy = 0;
    measurement.yy = rowSdPx * rowSdPx;
    double most = line.isDoubtful(k) ? Math.min(gate, DOUBTFUL_GATE) : gate;
    boolean accepted = track.compare(measurement) <= most;
    if (accepted) {
      track.take(measurement.timeUs, timeUs);
      line.pass(k, measurement.x, track.motion.vy());
      if (!line.isCut(k)) {
        line.learnWidth(k);
      }
      if (track.id == 0 && track.updates >= settings.life().updatesTillShown()) {
        track.id = tracks.nextId();
      }
    } else {
      track.gatedInARow++;
    }
    if (track.id > 0) {
      listener.updated(track, measurement, accepted);
    }
  }

  /** What should have passed a row by far, but is silent, is before that row. */
  private void waitFor(Track track, long timeUs) {
    RoadLine line = track.line;
    track.look(timeUs);
    double perRow = road.distancePerY(plane.yPx);
    double mostSpeed = Math.sqrt(2 * BRAKE_M_S2 * LATE_ROWS * perRow) + SPEED_ERROR_M_S;
    if (!VehicleEnds.mayStand(perRow) || line.last.speedMS() > mostSpeed) {
      return;
    }
    double gone = plane.yPx - line.last.row();
    boolean late = Math.abs(gone) >= LATE_ROWS;
    boolean rests =
        Math.abs(track.motion.vy()) < VehicleEnds.STANDING_M_S
            && timeUs - track.stateUs > REST_EACH_US;
    if (!late && !rests
        || !line.isSilent()
        || isHidden(track)
        || !VehicleEnds.isInPicture(plane, sensor)) {
      return;
    }
    measurement.timeUs = timeUs;
    measurement.x = line.last.column();
    measurement.y = late ? line.last.row() + 0.5 * Math.signum(gone) : plane.yPx;
    measurement.xx = CUT_VARIANCE;
    measurement.xy = 0;
    measurement.yy = late ? LATE_VARIANCE : REST_VARIANCE;
    if (track.compare(measurement) < gate) {
      track.rest(timeUs);
      track.motion.goOnly(line.last.forward());
    }
  }

  /** Whether another vehicle is in front of it. */
  private boolean isHidden(Track track) {
    for (int i = 0; i < tracks.count(); i++) {
      Track other = tracks.get(i);
      if (other != track
          && other.motion.y() < track.motion.y()
          && other.line.isInFrontOf(track.line)) {
        return true;
      }
    }
    return false;
  }
}
