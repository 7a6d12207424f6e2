package haltere.filters.track.kalman;

import haltere.core.chain.FilterProvider;
import haltere.core.chain.Outlet;
import haltere.core.chain.PublishingFilter;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.filters.track.KalmanTracksSettings;
import haltere.filters.track.LineCrossing;
import haltere.filters.track.MeasurementSource;
import haltere.filters.track.RoadMapping;
import haltere.filters.track.RoadMarks;
import haltere.filters.track.RoadTrackPoint;
import haltere.filters.track.TrackOverlay;
import haltere.filters.track.TrackPoint;
import haltere.filters.track.TrackSnapshot;
import haltere.filters.track.TrackUpdate;
import haltere.filters.track.motion.MotionModes;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * {@link TrackEstimator} as a stage of a chain. Lets all events through. Publishes
 *
 * <ul>
 *   <li>{@code tracks}: a {@link TrackPoint} for each track at each report;
 *   <li>{@code road-tracks}: a {@link RoadTrackPoint} for each, where there is a road;
 *   <li>{@code estimates}: a {@link TrackUpdate} for each measurement of each track;
 *   <li>{@code crossings}: a {@link LineCrossing} for each vehicle at each counting line;
 *   <li>{@code track-snapshot}: a {@link TrackSnapshot} at each report.
 * </ul>
 */
public final class KalmanTracksFilter extends PublishingFilter<KalmanTracksSettings> {
  private final Outlet<TrackPoint> points = outlet("tracks", TrackPoint.class);
  private final Outlet<RoadTrackPoint> roadPoints = outlet("road-tracks", RoadTrackPoint.class);
  private final Outlet<TrackUpdate> updates = outlet("estimates", TrackUpdate.class);
  private final Outlet<LineCrossing> crossings = outlet("crossings", LineCrossing.class);
  private final Outlet<TrackSnapshot> snapshots =
      drawnOutlet("track-snapshot", TrackSnapshot.class, "tracks", new TrackOverlay());
  private final Map<Integer, ArrayDeque<TrackPoint>> paths = new HashMap<>();
  private final TrackEstimator estimator;
  private LineCounter counter;

  /**
   * A filter in its initial state.
   *
   * @param geometry the sensor whose events it will see
   * @param settings what to do
   */
  public KalmanTracksFilter(SensorGeometry geometry, KalmanTracksSettings settings) {
    estimator = new TrackEstimator(geometry, settings, new Publisher());
    counter = new LineCounter(settings.road(), crossings::publish);
  }

  @Override
  public void process(EventPacket packet) {
    estimator.track(packet);
  }

  @Override
  public void reset() {
    estimator.reset();
    paths.clear();
    counter = new LineCounter(settings().road(), crossings::publish);
  }

  /** Time goes on over a gap in the data, and tracks coast for as long as they do anyway. */
  @Override
  public boolean bridgesGaps() {
    return true;
  }

  /**
   * Where the tracks come out.
   *
   * @return a result for each track that is shown, at each report
   */
  public Outlet<TrackPoint> points() {
    return points;
  }

  /**
   * Where the tracks on a road come out.
   *
   * @return a result for each track that is shown, at each report, right after that of {@link
   *     #points}; nothing without a road, and nothing for a track on a line above the road, wider
   *     than any vehicle or beside the lanes, for that is not where it would be on the road
   */
  public Outlet<RoadTrackPoint> roadPoints() {
    return roadPoints;
  }

  /**
   * Where the steps of the filters come out.
   *
   * @return a result for each measurement of each track
   */
  public Outlet<TrackUpdate> updates() {
    return updates;
  }

  /**
   * Where vehicles that cross counting lines come out.
   *
   * @return a result for each vehicle at each line; nothing without a road or without lines
   */
  public Outlet<LineCrossing> crossings() {
    return crossings;
  }

  @Override
  public KalmanTracksSettings settings() {
    return estimator.settings();
  }

  @Override
  public void apply(KalmanTracksSettings settings) {
    boolean sameRoad = settings.road().equals(settings().road());
    estimator.apply(settings);
    if (!sameRoad) {
      counter = new LineCounter(settings.road(), crossings::publish);
    }
  }

  /** Makes results of what the estimator says. */
  private final class Publisher implements TrackListener {
    @Override
    public void reported(long timeUs) {
      boolean drawn = snapshots.hasSubscribers();
      if (!drawn && !points.hasSubscribers() && !roadPoints.hasSubscribers()) {
        return;
      }
      List<TrackSnapshot.Shown> shown = drawn ? new ArrayList<>() : null;
      for (int i = 0; i < estimator.trackCount(); i++) {
        Track track = estimator.shown(i, timeUs);
        if (track != null) {
          TrackPoint point = point(track, timeUs);
          points.publish(point);
          MotionModes motion = track.at(timeUs);
          boolean onRoad = estimator.road() != null && !track.line.grounding.isBeside();
          if (onRoad && roadPoints.hasSubscribers()) {
            roadPoints.publish(roadPoint(track, motion, timeUs));
          }
          if (drawn) {
            shown.add(
                new TrackSnapshot.Shown(
                    List.copyOf(path(point)),
                    estimator.plane().covarianceXyPx2,
                    track.isUnseen(timeUs) || track.contested,
                    onRoad ? RoadSpeed.kmH(motion) : Double.NaN,
                    onRoad ? RoadSpeed.sdKmH(track, motion) : Double.NaN));
          }
        }
      }
      if (drawn) {
        snapshots.publish(new TrackSnapshot(timeUs, shown, marks()));
      }
    }

    private Optional<RoadMarks> marks() {
      RoadMapping road = estimator.road();
      return road == null
          ? Optional.empty()
          : Optional.of(
              new RoadMarks(
                  road, estimator.geometry(), settings().road().lanes(), counter.lines()));
    }

    private TrackPoint point(Track track, long timeUs) {
      MeasurementPlane at = estimator.plane();
      return new TrackPoint(
          timeUs,
          track.id,
          at.xPx,
          at.yPx,
          at.vxPxS,
          at.vyPxS,
          Math.sqrt(at.varianceXPx2),
          Math.sqrt(at.varianceYPx2),
          Math.sqrt(at.varianceVxPx2S2),
          Math.sqrt(at.varianceVyPx2S2),
          Math.round(track.events));
    }

    private RoadTrackPoint roadPoint(Track track, MotionModes motion, long timeUs) {
      // A line above the road is too fast, too far away and too far aside in one proportion.
      double unsure = track.line.grounding.speedShare();
      double unsureSpeed = RoadSpeed.share(track);
      return new RoadTrackPoint(
          timeUs,
          track.id,
          motion.x(),
          motion.y(),
          motion.vx(),
          motion.vy(),
          Math.hypot(Math.sqrt(motion.covariance(0, 0)), unsure * motion.x()),
          Math.hypot(Math.sqrt(motion.covariance(1, 1)), unsure * motion.y()),
          Math.hypot(Math.sqrt(motion.covariance(2, 2)), unsureSpeed * motion.vx()),
          Math.hypot(Math.sqrt(motion.covariance(3, 3)), unsureSpeed * motion.vy()),
          RoadSpeed.kmH(motion),
          RoadSpeed.sdKmH(track, motion),
          settings().road().lanes().laneAt(motion.x()));
    }

    private ArrayDeque<TrackPoint> path(TrackPoint point) {
      ArrayDeque<TrackPoint> path = paths.computeIfAbsent(point.id(), id -> new ArrayDeque<>());
      path.add(point);
      long fromUs = point.timeUs() - Math.round(settings().life().pathS() * 1e6);
      while (path.size() > 1 && path.peekFirst().timeUs() < fromUs) {
        path.removeFirst();
      }
      return path;
    }

    @Override
    public void updated(Track track, Measurement measurement, boolean accepted) {
      boolean byClusters = settings().measurement().source() != MeasurementSource.OUTLINE;
      if (accepted && estimator.road() != null && byClusters) {
        counter.look(track, track.stateUs, null);
      }
      if (updates.hasSubscribers()) {
        updates.publish(track.lastUpdate(measurement.timeUs, accepted));
      }
    }

    @Override
    public void moved(Track track, long timeUs, WayBack back) {
      counter.look(track, timeUs, back);
    }

    @Override
    public void ended(int id) {
      paths.remove(id);
    }
  }

  /** Makes the filter where its name is found in a chain. */
  public static final class Provider implements FilterProvider<KalmanTracksSettings> {
    @Override
    public String name() {
      return "kalman-tracks";
    }

    @Override
    public String description() {
      return "Follows things that move with Kalman filters on clusters of events, in pixels or in"
          + " metres on a road.";
    }

    @Override
    public Class<KalmanTracksSettings> settingsType() {
      return KalmanTracksSettings.class;
    }

    @Override
    public Map<String, KalmanTracksSettings> presets() {
      return Map.of("original", KalmanTracksSettings.original());
    }

    @Override
    public KalmanTracksFilter create(SensorGeometry geometry, KalmanTracksSettings settings) {
      return new KalmanTracksFilter(geometry, settings);
    }
  }
}
