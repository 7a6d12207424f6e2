package haltere.filters.track;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;

/**
 * Follows vehicles on a road by the edge at which each meets the road nearest to the camera.
 *
 * <p>The middle of a vehicle's events is no point of the vehicle: it wanders with the perspective
 * and with what the border hides. An edge across the road is one, and a row of pixels is passed by
 * it at a moment that is known far better than a pixel is wide. So a vehicle is found as a line
 * that goes over several rows ({@link LineSearch}), each row that it passes is a measurement of its
 * {@link Track} ({@link RowPassing}), and other lines that move with it are parts of it.
 *
 * <p>Thread rule: that of its owner.
 */
final class RoadVehicles {
  private static final double SIDE_M = 0.3;

  /** Lines of one vehicle have speeds that differ by less than this share, and three sigmas. */
  private static final double LIKE_SHARE = 0.15;

  /** Two edges of one vehicle that both become darker, or both brighter, are nearer than this. */
  private static final double SAME_EDGE_M = 2.5;

  /** Where one becomes darker and one brighter they may be its front and its rear. */
  private static final double OTHER_EDGE_M = 5.2;

  /** What a line has to have of the width of a vehicle that it is to stand for. */
  private static final double WIDTH_SHARE = 0.5;

  private static final double VARIANCE_X = 0.1;

  /** How fast a vehicle may be across the road, standard deviation. */
  private static final double LATERAL_SD_M_S = 1.5;

  private final RoadMapping road;
  private final SensorGeometry sensor;
  private final Tracks tracks;
  private final MeasurementPlane plane;
  private final RoadEvents events;
  private final LineSeeds seeds;
  private final LineSearch search;
  private final RowPassing passing;
  private final VehicleEnds ends;
  private final LineInSpace upper = new LineInSpace();
  private final LineInSpace lower = new LineInSpace();
  private KalmanTracksSettings settings;

  RoadVehicles(
      RoadMapping road,
      SensorGeometry sensor,
      Tracks tracks,
      MeasurementPlane plane,
      TrackListener listener) {
    this.road = road;
    this.sensor = sensor;
    this.tracks = tracks;
    this.plane = plane;
    events = new RoadEvents(road, sensor);
    seeds = new LineSeeds(events, sensor.width());
    search = new LineSearch(events, sensor.width());
    passing = new RowPassing(road, sensor, tracks, plane, listener);
    ends = new VehicleEnds(road, sensor, plane);
  }

  /** Does something else from the next step on; a gate is a normalised innovation squared. */
  void apply(KalmanTracksSettings newSettings, double gate) {
    settings = newSettings;
    passing.apply(newSettings, gate);
    ends.apply(newSettings.life());
  }

  void reset() {
    events.clear();
  }

  /** Takes events for the steps to come. */
  void add(EventPacket packet) {
    events.add(packet);
  }

  /** Whether there is anything that a step at a time would see. */
  boolean isWaiting(long timeUs) {
    return events.isWaiting(timeUs);
  }

  /** Goes on to a time with the events before it. */
  void step(long timeUs) {
    events.step(timeUs);
    for (int i = 0; i < tracks.count(); i++) {
      Track track = tracks.get(i);
      track.line.expect(track, plane, timeUs, metresPerColumn(track), sensor.width());
    }
    for (long i = events.from(); i < events.to(); i++) {
      give(i);
    }
    for (int i = 0; i < tracks.count(); i++) {
      passing.measure(tracks.get(i), timeUs);
    }
    unite(timeUs);
    for (int i = tracks.count() - 1; i >= 0; i--) {
      if (ends.isOver(tracks.get(i), timeUs)) {
        tracks.drop(i);
      }
    }
    int found = seeds.find(timeUs);
    for (int i = 0; i < found; i++) {
      if (search.find(seeds.get(i), timeUs, passing.rowSdPx()) && !isPartOfKnown(timeUs)) {
        launch(timeUs);
      }
    }
  }

  private double metresPerColumn(Track track) {
    return road.pixelAngle()
        * Math.hypot(road.settings().bridgeHeightM(), Math.max(0, track.motion.y()));
  }

  /** Gives an event to the line that it is nearest to, or else to the vehicle that it is on. */
  private void give(long event) {
    long timeUs = events.timeUs(event);
    int column = events.column(event);
    int row = events.row(event);
    boolean on = events.isOn(event);
    double lateralM = events.lateralM(column, row);
    double perColumnM = events.metresPerColumn(row);
    Track line = null;
    Track body = null;
    double least = Double.POSITIVE_INFINITY;
    double bodyAbove = 0;
    for (int k = 0; k < tracks.count(); k++) {
      Track track = tracks.get(k);
      double above = track.line.above(timeUs, column, row, lateralM, perColumnM);
      if (!track.line.isOnVehicle(above)) {
        continue;
      }
      if (!track.line.isOnLine(above, on)) {
        body = track;
        bodyAbove = above;
      } else if (Math.abs(above) < least) {
        line = track;
        least = Math.abs(above);
      }
    }
    if (line != null) {
      line.line.takeLine(timeUs, column, row);
      line.events++;
      events.take(event);
    } else if (body != null) {
      body.line.hear(timeUs);
      if (!body.line.isLost()) {
        body.line.learnExtent(bodyAbove);
        body.events++;
        events.take(event);
      }
    }
  }

  /** Whether the line that was found is of a vehicle that is known, which then knows of it. */
  private boolean isPartOfKnown(long timeUs) {
    for (int i = 0; i < tracks.count(); i++) {
      if (isPartOf(tracks.get(i), timeUs)) {
        search.take();
        return true;
      }
    }
    return false;
  }

  private boolean isPartOf(Track track, long timeUs) {
    MotionModes motion = track.at(timeUs);
    RoadLine line = track.line;
    if (isPartOfTall(track, motion, timeUs)) {
      return true;
    }
    double wide = Math.max(search.halfWidthM, line.halfWidthM) + SIDE_M;
    if (Math.abs(search.xM - motion.x()) > wide) {
      return false;
    }
    double higherM = search.yM - motion.y();
    double perRow = events.metresPerRow(search.lastRow);
    double extentM = line.extentPx() * perRow;
    boolean sameWay = search.vyMS * motion.vy() > 0;
    if (line.isLost() && sameWay && Math.abs(higherM) < Math.max(OTHER_EDGE_M, extentM)) {
      line.change(search, -higherM / perRow, timeUs);
      track.moveOn(search, VARIANCE_X, LATERAL_SD_M_S * LATERAL_SD_M_S, timeUs);
      return true;
    }
    double sd = Math.sqrt(motion.covariance(3, 3) + search.varianceVy);
    double unlike = Math.abs(search.vyMS - motion.vy());
    if (unlike > LIKE_SHARE * Math.abs(motion.vy()) + 3 * sd) {
      return false;
    }
    double gapM = search.on == line.on() ? SAME_EDGE_M : OTHER_EDGE_M;
    boolean below = higherM < 0 && search.halfWidthM > WIDTH_SHARE * line.halfWidthM;
    if (higherM <= -gapM || higherM >= Math.max(gapM, extentM + SAME_EDGE_M)) {
      return false;
    }
    if (below) {
      line.change(search, -higherM / perRow, timeUs);
      track.motion.shift(higherM, search.varianceY);
    } else {
      line.reachTo(higherM / perRow);
    }
    return true;
  }

  /** Whether the line is as much farther, faster and wider as a higher one of a vehicle is. */
  private boolean isPartOfTall(Track track, MotionModes motion, long timeUs) {
    upper.set(search.xM, search.yM, search.vyMS, search.varianceVy, search.halfWidthM);
    lower.set(track, motion);
    RoadLine line = track.line;
    double gapPx = road.rowOf(search.yM) - road.rowOf(motion.y());
    if (line.mayReach(gapPx) && upper.isAbove(lower, gapPx / line.halfPx())) {
      line.reachTo(gapPx);
      return true;
    }
    if (lower.isAbove(upper, -gapPx / line.halfPx())) {
      line.change(search, -gapPx, timeUs);
      track.moveOn(search, VARIANCE_X, LATERAL_SD_M_S * LATERAL_SD_M_S, timeUs);
      return true;
    }
    return false;
  }

  /** Of two tracks on two edges of one tall vehicle, the lower one stays, under the older name. */
  private void unite(long timeUs) {
    for (int i = tracks.count() - 1; i >= 0; i--) {
      Track track = tracks.get(i);
      upper.set(track, track.at(timeUs));
      for (int k = 0; k < tracks.count(); k++) {
        Track other = tracks.get(k);
        lower.set(other, other.at(timeUs));
        double gapPx = track.line.rowNow() - other.line.rowNow();
        if (k != i
            && other.line.mayReach(gapPx)
            && upper.isAbove(lower, gapPx / other.line.halfPx())) {
          other.line.reachTo(gapPx);
          other.nameAfter(track);
          tracks.drop(i);
          break;
        }
      }
    }
  }

  private void launch(long timeUs) {
    if (tracks.isFull()) {
      return;
    }
    Track track = tracks.add();
    track.launchLine(search, VARIANCE_X, LATERAL_SD_M_S * LATERAL_SD_M_S, timeUs);
    track.line.begin(search, timeUs);
    search.take();
    if (settings.life().updatesTillShown() <= 1) {
      track.id = tracks.nextId();
    }
    ends.isOver(track, timeUs);
  }
}
