package haltere.filters.orientation;

import haltere.filters.orientation.camera.CameraModel;
import haltere.filters.orientation.camera.LineObservation;
import java.util.ArrayList;
import java.util.List;

/** Sorts out which observations of one time can be used at all, and keeps what cameras last saw. */
final class LineIntake {
  /** Counts what became of observations. */
  interface Counter {
    void count(OrientationCount what, long number);
  }

  private final List<CameraModel> cameras;
  private final double togetherUs;
  private final LineObservation[] latest;
  private final long[] latestUs;
  private final List<LineObservation> usable = new ArrayList<>();
  private final List<LineObservation> views = new ArrayList<>();
  private boolean together;

  LineIntake(List<CameraModel> cameras, double togetherS) {
    this.cameras = cameras;
    togetherUs = togetherS * 1e6;
    latest = new LineObservation[cameras.size()];
    latestUs = new long[cameras.size()];
  }

  /** Sorts out what cannot be used. */
  void take(long timeUs, List<LineObservation> seen, Counter counter) {
    usable.clear();
    for (LineObservation observation : seen) {
      int camera = observation.camera();
      if (camera >= cameras.size()) {
        throw new IllegalArgumentException(
            "there is no camera " + camera + ", there are " + cameras.size());
      }
      if (cameras.get(camera).problem().isPresent()) {
        counter.count(OrientationCount.UNUSABLE_CAMERA, 1);
      } else if (latestUs[camera] == timeUs && usable.contains(latest[camera])) {
        counter.count(OrientationCount.TWICE, 1);
      } else {
        usable.add(observation);
        latest[camera] = observation;
        latestUs[camera] = timeUs;
      }
    }
    together |= usable.size() > 1;
  }

  /** What can be used of the last time; valid until the next one. */
  List<LineObservation> usable() {
    return usable;
  }

  /**
   * What goes together: what was seen now if cameras look at the same times, else the last views
   * that are recent enough.
   */
  List<LineObservation> recent(long timeUs) {
    if (together) {
      return usable;
    }
    views.clear();
    for (int i = 0; i < latest.length; i++) {
      if (latest[i] != null && timeUs - latestUs[i] <= togetherUs) {
        views.add(latest[i]);
      }
    }
    return views;
  }
}
