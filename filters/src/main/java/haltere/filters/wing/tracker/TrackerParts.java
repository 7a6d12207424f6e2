package haltere.filters.wing.tracker;

import haltere.core.event.SensorGeometry;
import haltere.filters.wing.WingMethod;
import haltere.filters.wing.WingModel;
import haltere.filters.wing.WingTrackerSettings;
import haltere.filters.wing.WingTrackerState;
import haltere.filters.wing.internal.original.CentroidSearch;
import haltere.filters.wing.internal.original.UpdateNoise;
import haltere.filters.wing.internal.search.FlySearch;
import haltere.filters.wing.internal.search.RecentEvents;
import haltere.filters.wing.internal.search.StrokeSearch;
import haltere.filters.wing.internal.stroke.BeatListener;
import haltere.filters.wing.internal.stroke.EdgeNoise;
import haltere.filters.wing.internal.stroke.EdgesEstimator;
import haltere.filters.wing.internal.stroke.SideEstimator;
import haltere.filters.wing.internal.stroke.StrokeFrame;
import haltere.filters.wing.internal.stroke.WingEstimator;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * Creates the parts of a tracker by its settings. The only class that knows the tracker of
 * Cardinale (2006), {@code wing.internal.original}.
 */
final class TrackerParts {
  private TrackerParts() {}

  static boolean isOriginal(WingTrackerSettings settings) {
    return settings.filter().model() == WingModel.ORIGINAL;
  }

  /** Whether the running average moves the body in the frames of the main method. */
  static boolean sharesFrames(WingTrackerSettings settings) {
    return settings.filter().method() == WingMethod.WRA
        || settings.filter().model() != WingModel.WINGS;
  }

  /** Whether a running average is used. */
  static boolean averages(WingTrackerSettings settings) {
    boolean updates = settings.average().bodyUpdate() || settings.average().headingUpdate();
    return settings.filter().method() != WingMethod.EKF || updates && sharesFrames(settings);
  }

  static FlySearch search(
      WingTrackerSettings settings,
      SensorGeometry sensor,
      RecentEvents recent,
      Consumer<WingTrackerState> steps) {
    return isOriginal(settings)
        ? new CentroidSearch(sensor, recent, steps)
        : new StrokeSearch(sensor, recent, steps);
  }

  /** The Kalman filter of a wing, or one for each of its edges. */
  static SideEstimator filter(StrokeFrame frame, WingTrackerSettings settings, BeatListener beats) {
    return switch (settings.filter().model()) {
      case WINGS -> new WingEstimator(frame, settings, beats);
      case EDGES -> new EdgesEstimator(frame, settings, beats, Optional.of(EdgeNoise.DENSITY));
      case ORIGINAL -> new EdgesEstimator(frame, settings, beats, Optional.of(new UpdateNoise()));
    };
  }
}
