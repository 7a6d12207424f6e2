package haltere.device.simulated;

import haltere.core.camera.CameraInfo;
import haltere.core.camera.CameraOptions;
import haltere.core.camera.CameraProblem;
import haltere.core.camera.RegionOfInterest.Region;
import haltere.core.event.EventPacket;
import haltere.core.pipeline.LiveBuffer;
import haltere.core.pipeline.OverflowPolicy;
import haltere.core.simulation.Scene;
import haltere.core.stream.DataLost;
import haltere.core.stream.DeviceLost;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import java.util.ArrayDeque;
import java.util.Optional;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.LongSupplier;
import java.util.function.Supplier;

/**
 * The device side of a simulated camera: transfers of a millisecond are created at their time and
 * queued for the consumer. The queue is bounded; further transfers are lost, counted and reported.
 *
 * <p>Its clock is live. If the simulation falls too far behind, the scene is paused for the missing
 * time, which is reported as a loss of unknown size. While the camera is unplugged the scene is
 * paused too, and the clock restarts from 0 when it is plugged in again.
 *
 * <p>Thread rule: all methods may be called from any thread; the lock is fair.
 */
final class SimulatedTransfers {
  static final long TRANSFER_US = 1000;

  private static final int TRANSFER_EVENTS = 1024;
  private static final int WAITING = 1024;
  private static final long NANOS_PER_US = 1000;
  private static final long UNKNOWN = -1;

  /** Maximum duration of one simulation step, during which others wait for the lock. */
  private static final long MAX_WORK_NANOS = 5_000_000;

  /** Maximum delay of the scene that is caught up. */
  private static final long MAX_LATE_US = 200_000;

  private final CameraInfo info;
  private final CameraOptions options;
  private final LongSupplier nanoTime;
  private final SimulatedSensor sensor;
  private final ReentrantLock lock = new ReentrantLock(true);

  // Below: guarded by the lock. Times of the scene are relative to its start.
  private final ArrayDeque<LiveBuffer> streams = new ArrayDeque<>();
  private final EventPacket transfer = new EventPacket(TRANSFER_EVENTS);
  private LiveBuffer filling;
  private boolean begun;
  private boolean pluggedIn = true;
  private boolean closed;

  /** Scene time up to which it is simulated. */
  private long madeUs;

  /** Scene time of 0 on the camera's clock. */
  private long zeroUs;

  /** When the scene began. */
  private long anchorNanos;

  private long lastUs = StreamNotification.NO_TIME_US;
  private boolean behind;
  private boolean eventsSeen;
  private long transfers;
  private long events;
  private long lostEarlier;
  private int maxWaiting;
  private long streamsBegun;
  private long timesBehind;

  /**
   * Counts of the transfers.
   *
   * @param transfers created transfers
   * @param events in them
   * @param lost lost events
   * @param waiting waiting transfers
   * @param maxWaiting largest number of waiting transfers
   * @param streams started streams
   * @param timesBehind number of pauses of the scene because the simulation was too slow
   */
  record TransferCounts(
      long transfers,
      long events,
      long lost,
      int waiting,
      int maxWaiting,
      long streams,
      long timesBehind) {}

  SimulatedTransfers(
      CameraInfo info, Scene<?> scene, CameraOptions options, LongSupplier nanoTime) {
    this.info = info;
    this.options = options;
    this.nanoTime = nanoTime;
    sensor = new SimulatedSensor(scene);
  }

  // ---- Making

  /** Starts the camera, if it has not been started yet. */
  void start() {
    locked(
        () -> {
          if (!begun && !closed && pluggedIn) {
            begin();
          }
        });
  }

  private void begin() {
    begun = true;
    zeroUs = madeUs;
    anchorNanos = nanoTime.getAsLong() - madeUs * NANOS_PER_US;
    lastUs = StreamNotification.NO_TIME_US;
    behind = false;
    int waiting = options.waitingBuffers() == 0 ? WAITING : Math.max(2, options.waitingBuffers());
    OverflowPolicy policy =
        options.whenFull() == CameraOptions.WhenFull.DROP_OLDEST
            ? OverflowPolicy.DROP_OLDEST
            : OverflowPolicy.DROP_NEWEST;
    filling =
        LiveBuffer.ofPackets(
            info.geometry(),
            waiting,
            TRANSFER_EVENTS,
            policy,
            info.id() + ": not consumed in time");
    streams.add(filling);
    streamsBegun++;
    filling.notified(new StreamStarted(info.geometry(), info.id()));
  }

  /** Current scene time. */
  private long sceneUs() {
    return Math.floorDiv(nanoTime.getAsLong() - anchorNanos, NANOS_PER_US);
  }

  /** Creates the transfers that are due, for some milliseconds at most. */
  void makeDue() {
    lock.lock();
    try {
      long beginNanos = nanoTime.getAsLong();
      while (filling != null && madeUs + TRANSFER_US <= sceneUs()) {
        make(madeUs + TRANSFER_US);
        if (nanoTime.getAsLong() - beginNanos > MAX_WORK_NANOS) {
          pauseScene(sceneUs() - madeUs);
          return;
        }
      }
    } finally {
      lock.unlock();
    }
  }

  /** Skips the late interval after the clock has advanced during the simulation. */
  private void pauseScene(long lateUs) {
    if (lateUs > MAX_LATE_US) {
      anchorNanos += lateUs * NANOS_PER_US;
      zeroUs -= lateUs;
      behind = true;
      timesBehind++;
    }
  }

  private void make(long untilUs) {
    transfer.clear();
    sensor.takeUntil(untilUs, zeroUs, transfer);
    madeUs = untilUs;
    if (!transfer.isEmpty()) {
      if (behind) {
        behind = false;
        String place = "this computer is too slow to simulate " + info.id();
        filling.notified(new DataLost(UNKNOWN, UNKNOWN, lastUs, transfer.firstTimeUs(), place));
      }
      transfers++;
      events += transfer.size();
      lastUs = transfer.lastTimeUs();
      eventsSeen = true;
      filling.packet(transfer);
    }
    if (sensor.isOver()) {
      end();
    }
  }

  private void end() {
    LiveBuffer.Counts counts = filling.counts();
    maxWaiting = Math.max(maxWaiting, counts.maxWaitingPackets());
    lostEarlier += counts.lost();
    filling.notified(new EndOfStream(lastUs));
    filling = null;
  }

  /** Nanoseconds until the next transfer is due; {@link Long#MAX_VALUE} if none will be. */
  long untilNextNanos() {
    return read(
        () -> {
          long dueNanos = anchorNanos + (madeUs + TRANSFER_US) * NANOS_PER_US;
          return filling == null ? Long.MAX_VALUE : Math.max(1, dueNanos - nanoTime.getAsLong());
        });
  }

  // ---- Taking

  /** The current stream of the consumer, or null. */
  LiveBuffer stream() {
    return read(streams::peek);
  }

  /** Removes a stream whose end the consumer has received. */
  void taken(LiveBuffer stream) {
    locked(() -> streams.remove(stream));
  }

  /** Whether no more transfers will be created. */
  boolean isOver() {
    return read(() -> closed || filling == null && (pluggedIn ? begun : !options.reconnect()));
  }

  /** Whether the consumer has received everything. */
  boolean isTaken() {
    return read(() -> streams.isEmpty() && isOver());
  }

  // ---- State and settings

  TransferCounts counts() {
    return read(
        () -> {
          int waiting = 0;
          long lost = lostEarlier;
          if (filling != null) {
            LiveBuffer.Counts counts = filling.counts();
            waiting = counts.waitingPackets();
            maxWaiting = Math.max(maxWaiting, counts.maxWaitingPackets());
            lost += counts.lost();
          }
          return new TransferCounts(
              transfers, events, lost, waiting, maxWaiting, streamsBegun, timesBehind);
        });
  }

  /** When the camera's clock was 0, by the clock of the computer; empty before the first event. */
  Optional<Long> zeroNanos() {
    return read(
        () -> eventsSeen ? Optional.of(anchorNanos + zeroUs * NANOS_PER_US) : Optional.empty());
  }

  /** Elapsed time since a time of the camera's clock. */
  long sinceUs(long cameraUs) {
    return read(() -> sceneUs() - zeroUs - cameraUs);
  }

  private void locked(Runnable action) {
    lock.lock();
    try {
      action.run();
    } finally {
      lock.unlock();
    }
  }

  /** Reads guarded state. */
  <T> T read(Supplier<T> question) {
    lock.lock();
    try {
      return question.get();
    } finally {
      lock.unlock();
    }
  }

  /** Changes the scene or the sensor, after the simulation up to now. */
  void change(Runnable change) {
    locked(
        () -> {
          makeDue();
          change.run();
        });
  }

  void resetTimestamps() throws CameraProblem {
    lock.lock();
    try {
      if (filling == null) {
        throw new CameraProblem(CameraProblem.Kind.GONE, info.id() + " does not run");
      }
      makeDue();
      if (filling != null) {
        make(Math.max(madeUs, sceneUs()));
      }
      if (filling != null) {
        filling.notified(new Reset(Reset.Cause.CLOCK_RESTARTED, lastUs, 0));
        zeroUs = madeUs;
        lastUs = StreamNotification.NO_TIME_US;
      }
    } finally {
      lock.unlock();
    }
  }

  Optional<Region> region() {
    return read(sensor::region);
  }

  void setRegion(Optional<Region> region) {
    change(() -> sensor.setRegion(region));
  }

  void unplug() {
    change(
        () -> {
          pluggedIn = false;
          if (filling != null) {
            filling.notified(new DeviceLost(info.id(), lastUs));
            end();
          }
        });
  }

  void plugIn() {
    locked(
        () -> {
          boolean wasOut = !pluggedIn;
          pluggedIn = true;
          if (wasOut && begun && !closed && options.reconnect() && !sensor.isOver()) {
            begin();
          }
        });
  }

  boolean isPluggedIn() {
    return read(() -> pluggedIn);
  }

  void close() {
    locked(
        () -> {
          if (!closed && filling != null) {
            end();
          }
          closed = true;
        });
  }
}
