package haltere.device.model;

import haltere.core.camera.ClockRelation;
import haltere.core.stream.StreamNotification;
import java.util.Optional;
import java.util.concurrent.TimeUnit;

/**
 * Relates a camera's clock to the computer's by the shortest delay of events in the last seconds.
 *
 * <p>Thread rule: one thread calls {@link #note}, any thread reads.
 */
final class ClockWatch {
  private static final long WINDOW_NANOS = TimeUnit.SECONDS.toNanos(2);
  private static final long NANOS_PER_US = 1000;

  private volatile ClockRelation relation;
  private ClockRelation recentShortest;
  private long windowEndNanos;
  private long lastUs = StreamNotification.NO_TIME_US;

  /**
   * Registers the arrival of a buffer.
   *
   * @param cameraUs time of the last event; a buffer without events, which repeats the time of an
   *     earlier one, says nothing of the delay
   * @param arrivedNanos by {@link System#nanoTime}
   */
  void note(long cameraUs, long arrivedNanos) {
    if (cameraUs == lastUs) {
      return;
    }
    lastUs = cameraUs;
    ClockRelation best = relation;
    boolean turn = best == null || arrivedNanos - windowEndNanos > 0;
    if (turn || recentShortest == null || shorter(cameraUs, arrivedNanos, recentShortest)) {
      ClockRelation now = new ClockRelation(cameraUs, arrivedNanos);
      if (turn) {
        windowEndNanos = arrivedNanos + WINDOW_NANOS;
        relation = recentShortest == null ? now : recentShortest;
        recentShortest = now;
      } else {
        recentShortest = now;
      }
      if (shorter(cameraUs, arrivedNanos, relation)) {
        relation = now;
      }
    }
  }

  private static boolean shorter(long cameraUs, long arrivedNanos, ClockRelation other) {
    return arrivedNanos - cameraUs * NANOS_PER_US
        < other.hostNanos() - other.cameraUs() * NANOS_PER_US;
  }

  /** The camera's clock restarts. */
  void restart() {
    relation = null;
    recentShortest = null;
    lastUs = StreamNotification.NO_TIME_US;
  }

  Optional<ClockRelation> relation() {
    return Optional.ofNullable(relation);
  }
}
