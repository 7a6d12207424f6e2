package haltere.filters.orientation;

import haltere.filters.orientation.camera.CameraModel;
import haltere.filters.orientation.camera.LineObservation;
import haltere.filters.orientation.line.BodyLine;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.function.BiConsumer;

/**
 * Online estimation of the orientation: receives the lines of the filters {@code body-line} of
 * several event cameras, on any thread and in any order, groups them by time, and passes them to a
 * {@link BodyOrientationEstimator}.
 *
 * <pre>{@code
 * LiveOrientation live = new LiveOrientation(cameras, OrientationSettings.defaults(), 20_000,
 *     (now, body) -> show(now));
 * left.lines().subscribe(line -> live.line(0, line));
 * right.lines().subscribe(line -> live.line(1, line));
 * }</pre>
 *
 * <p>The clocks of the cameras must be synchronised. A time is complete when each camera has
 * reached it; a silent camera is awaited for the configured time only. Later lines are counted and
 * dropped, so that times ascend.
 *
 * <p>Thread rule: safe for use by several threads; the listener is called on one of them at a time.
 */
public final class LiveOrientation {
  private final List<CameraModel> cameras;
  private final OrientationSettings settings;
  private final long waitUs;
  private final BiConsumer<? super OrientationEstimate, ? super BodyOrientationEstimator> listener;
  private final TreeMap<Long, List<LineObservation>> pending = new TreeMap<>();
  private final long[] reachedUs;
  private BodyOrientationEstimator body;
  private long newestUs;
  private long doneUs;
  private long late;

  /**
   * An estimation in its initial state.
   *
   * @param cameras the calibrated cameras, in the order of the numbers given to {@link #line}
   * @param settings of the estimator
   * @param waitUs longest wait for a camera, microseconds of the events' clock, not negative
   * @param listener receives each orientation and the estimator, for residuals and counts; the
   *     estimator must not be stored
   */
  public LiveOrientation(
      List<CameraModel> cameras,
      OrientationSettings settings,
      long waitUs,
      BiConsumer<? super OrientationEstimate, ? super BodyOrientationEstimator> listener) {
    if (waitUs < 0) {
      throw new IllegalArgumentException("waitUs must not be negative: " + waitUs);
    }
    this.cameras = List.copyOf(cameras);
    this.settings = Objects.requireNonNull(settings, "settings");
    this.waitUs = waitUs;
    this.listener = Objects.requireNonNull(listener, "listener");
    reachedUs = new long[this.cameras.size()];
    reset();
  }

  /** Returns to the initial state, for example after the clocks were set. */
  public synchronized void reset() {
    body = new BodyOrientationEstimator(cameras, settings);
    pending.clear();
    Arrays.fill(reachedUs, Long.MIN_VALUE);
    newestUs = Long.MIN_VALUE;
    doneUs = Long.MIN_VALUE;
  }

  /**
   * Receives a line of a camera.
   *
   * @param camera its number, from 0
   * @param line a line; those of one camera ascend in time
   */
  public synchronized void line(int camera, BodyLine line) {
    Objects.checkIndex(camera, reachedUs.length);
    if (line.timeUs() <= doneUs) {
      late++;
      return;
    }
    pending.computeIfAbsent(line.timeUs(), time -> new ArrayList<>()).add(line.observation(camera));
    reached(camera, line.timeUs());
  }

  /**
   * Reports that a camera has reached a time, with or without a line, so that others need not wait
   * for it.
   *
   * @param camera its number, from 0
   * @param timeUs all its lines up to this time were received
   */
  public synchronized void reached(int camera, long timeUs) {
    reachedUs[camera] = Math.max(reachedUs[camera], timeUs);
    newestUs = Math.max(newestUs, timeUs);
    long slowest = Long.MAX_VALUE;
    for (long each : reachedUs) {
      slowest = Math.min(slowest, each);
    }
    advance(Math.max(slowest, newestUs - waitUs));
  }

  /** Processes waiting lines at the end of a stream. */
  public synchronized void finish() {
    advance(Long.MAX_VALUE);
  }

  private void advance(long completeUs) {
    while (!pending.isEmpty() && pending.firstKey() <= completeUs) {
      Map.Entry<Long, List<LineObservation>> first = pending.pollFirstEntry();
      doneUs = first.getKey();
      body.update(doneUs, first.getValue()).ifPresent(now -> listener.accept(now, body));
    }
  }

  /** Number of late lines, which were dropped. */
  synchronized long late() {
    return late;
  }
}
