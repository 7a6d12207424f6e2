package haltere.filters.track.kalman;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.filters.track.KalmanTracksSettings;
import haltere.filters.track.LaneSettings;
import haltere.filters.track.RoadMapping;
import haltere.filters.track.motion.MotionModes;
import haltere.filters.track.road.FoundLine;
import haltere.filters.track.road.LineSearch;
import haltere.filters.track.road.LineSeeds;
import haltere.filters.track.road.RoadEvents;
import haltere.filters.track.road.VehicleSize;

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
  /** What is farther behind a line than this may be another vehicle. */
  private static final double OWN_M = 8;

  /** What is lost within so many metres of what the bottom row sees has left the picture there. */
  private static final double LEAVING_M = 3;

  /** A track that is older is no roof of something that has just left. */
  private static final long YOUNG_US = 700_000;

  private static final double NEAREST_M = 1;

  /** Number of those that have left the picture. */
  private static final int DEPARTED = -1;

  private final RoadMapping road;
  private final SensorGeometry sensor;
  private final Tracks tracks;
  private final MeasurementPlane plane;
  private final RoadEvents events;
  private final LineSeeds seeds;
  private final LineSearch search;
  private final FoundLine found;
  private final RowPassing passing;
  private final VehicleEnds ends;
  private final DepartedVehicles departed = new DepartedVehicles();
  private final VehicleParts parts;
  private final SeenWay way;
  private final WayBack back = new Past();
  private final TrackListener listener;
  private final double leavingM;
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
    leavingM = road.distanceM(0) + LEAVING_M;
    seeds = new LineSeeds(events, sensor.width());
    search = new LineSearch(events, sensor.width());
    found = search.found();
    passing = new RowPassing(road, sensor, tracks, plane, listener);
    ends = new VehicleEnds(road, sensor, plane);
    parts = new VehicleParts(road, events, found);
    way = new SeenWay(road, events);
    this.listener = listener;
  }

  /** Does something else from the next step on; a gate is a normalised innovation squared. */
  void apply(KalmanTracksSettings newSettings, double gate) {
    settings = newSettings;
    passing.apply(newSettings, gate);
    ends.apply(newSettings.life());
  }

  void reset() {
    events.clear();
    departed.clear();
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
      double mostPx = mostPx(track);
      track.line.setOwn(Math.min(ownPx(track), mostPx), mostPx, endM(track));
    }
    for (long i = events.from(); i < events.to(); i++) {
      give(i);
    }
    for (int i = 0; i < tracks.count(); i++) {
      passing.measure(tracks.get(i), timeUs);
    }
    parts.unite(tracks, timeUs);
    for (int i = tracks.count() - 1; i >= 0; i--) {
      end(i, timeUs);
    }
    int pieces = seeds.find(timeUs);
    for (int i = 0; i < pieces; i++) {
      if (search.find(seeds.get(i), timeUs, passing.rowSdPx())
          && !isPartOfKnown(timeUs, seeds.isSure(i))
          && seeds.isSure(i)) {
        launch(timeUs);
      }
    }
    for (int i = 0; i < tracks.count(); i++) {
      if (tracks.get(i).id > 0) {
        listener.moved(tracks.get(i), timeUs, back);
      }
    }
  }

  /** What the counting of vehicles asks. */
  private final class Past implements WayBack {
    @Override
    public boolean leadsTo(Track track, MotionModes motion, double lineM, long timeUs) {
      return !mayBeHigher(track, motion, timeUs) && way.leadsTo(track, motion, lineM, timeUs);
    }

    @Override
    public boolean isOnOther(Track track, MotionModes motion, long timeUs) {
      for (int i = 0; i < tracks.count(); i++) {
        Track other = tracks.get(i);
        if (other != track && parts.mayBeAbove(track, motion, other, other.at(timeUs))) {
          return true;
        }
      }
      return isOnDeparted(track, motion, timeUs);
    }
  }

  /** Whether a track may be on a higher line of another vehicle, of which it then has the way. */
  private boolean mayBeHigher(Track track, MotionModes motion, long timeUs) {
    for (int i = 0; i < tracks.count(); i++) {
      Track other = tracks.get(i);
      if (other != track
          && DepartedVehicles.isOf(motion, track.line, other.at(timeUs), other.line)) {
        return true;
      }
    }
    return isOnDeparted(track, motion, timeUs);
  }

  private boolean isOnDeparted(Track track, MotionModes motion, long timeUs) {
    double half = track.line.halfWidthM;
    return departed.own(motion.x(), motion.y(), motion.vy(), half, timeUs);
  }

  /**
   * Up to so far above its line all that is seen is of a vehicle. What is farther away may be of
   * the next one, unless it is known that the vehicle is high.
   */
  private double ownPx(Track track) {
    double yM = track.motion.y();
    return track.line.grounding.hasUpper()
        ? Double.POSITIVE_INFINITY
        : road.rowOf(yM + OWN_M) - road.rowOf(yM);
  }

  /** How far away its far end is at most. */
  private double endM(Track track) {
    RoadLine line = track.line;
    double half = line.isWidthKnown() ? line.halfWidthM : Double.POSITIVE_INFINITY;
    return Math.max(NEAREST_M, road.distanceM(line.rowNow())) + VehicleSize.longestWideM(half);
  }

  /** How far above its line a vehicle may be seen if it is no higher than one so wide may be. */
  private double mostPx(Track track) {
    double yM = track.motion.y();
    RoadLine line = track.line;
    double half = line.isWidthKnown() ? line.halfWidthM : Double.POSITIVE_INFINITY;
    double scale = VehicleSize.mostScale(half, road.settings().bridgeHeightM());
    return yM > 0
        ? road.rowOf(scale * (yM + line.lengthM())) - road.rowOf(yM)
        : Double.POSITIVE_INFINITY;
  }

  /** Ends a track whose vehicle is gone, or that is on the roof of one that is. */
  private void end(int index, long timeUs) {
    Track track = tracks.get(index);
    MotionModes motion = track.motion;
    RoadLine line = track.line;
    look(track, timeUs);
    if (ends.isOver(track, timeUs)) {
      if (motion.vy() < -VehicleEnds.STANDING_M_S && (line.isCut() || motion.y() < leavingM)) {
        departed.add(track.at(timeUs), line, timeUs);
      }
      tracks.drop(index);
    } else if (timeUs - track.bornUs < YOUNG_US
        && departed.own(motion.x(), motion.y(), motion.vy(), line.halfWidthM, timeUs)) {
      tracks.drop(index);
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
    double alongM = events.distanceM(row);
    double perColumnM = events.metresPerColumn(row);
    Track line = null;
    Track body = null;
    double least = Double.POSITIVE_INFINITY;
    double bodyAbove = 0;
    for (int k = 0; k < tracks.count(); k++) {
      Track track = tracks.get(k);
      double above = track.line.above(timeUs, column, row, lateralM, alongM, perColumnM);
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
      events.take(event, line.serial);
    } else if (body != null) {
      body.line.hear(timeUs);
      if (!body.line.isLost()) {
        body.line.learnExtent(bodyAbove);
        body.events++;
        if (bodyAbove < body.line.ownPx()) {
          events.take(event, body.serial);
        }
      }
    }
  }

  /** Whether the line that was found is of a vehicle that is known, which then knows of it. */
  private boolean isPartOfKnown(long timeUs, boolean isSure) {
    if (departed.own(found.xM(), found.yM(), found.vyMS(), found.halfWidthM(), timeUs)) {
      search.take(DEPARTED);
      return true;
    }
    for (int i = 0; i < tracks.count(); i++) {
      Track track = tracks.get(i);
      if ((isSure || track.line.halfWidthM < VehicleSize.NARROW_HALF_M)
          && parts.isPartOf(track, timeUs)) {
        search.take(tracks.get(i).serial);
        return true;
      }
    }
    return false;
  }

  private void launch(long timeUs) {
    if (tracks.isFull() || found.isCut()) {
      return;
    }
    Track track = tracks.add();
    track.launchLine(found, timeUs);
    track.line.begin(found, timeUs);
    track.line.grounding.begin(found.vyMS() > 0);
    search.take(track.serial);
    if (settings.life().updatesTillShown() <= 1) {
      track.id = tracks.nextId();
    }
    look(track, timeUs);
  }

  /** Notes where a vehicle is, and whether it can be there. */
  private void look(Track track, long timeUs) {
    LaneSettings lanes = settings.road().lanes();
    track.line.grounding.look(track.motion, track.line, road, sensor, lanes);
    ends.look(track, timeUs);
  }
}
