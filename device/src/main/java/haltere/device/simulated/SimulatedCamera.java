package haltere.device.simulated;

import haltere.core.camera.BiasSliders;
import haltere.core.camera.Biases;
import haltere.core.camera.Camera;
import haltere.core.camera.CameraInfo;
import haltere.core.camera.CameraOptions;
import haltere.core.camera.CameraProblem;
import haltere.core.camera.CameraStatistics;
import haltere.core.camera.ClockRelation;
import haltere.core.camera.Configuration;
import haltere.core.camera.RegionOfInterest;
import haltere.core.camera.TimestampReset;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorReading;
import haltere.core.pipeline.LiveBuffer;
import haltere.core.pipeline.OverflowPolicy;
import haltere.core.playback.Sleeper;
import haltere.core.simulation.Scene;
import haltere.core.simulation.TunableScene;
import haltere.core.stream.DeviceLost;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import java.io.InterruptedIOException;
import java.util.ArrayDeque;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.LongSupplier;

/**
 * A scene that behaves as a camera. Events come in transfers of a millisecond, at the time at which
 * a camera would send them; a bounded number of transfers waits for the consumer, and what finds no
 * room is lost, counted and told. The scene is simulated when the consumer comes, on its thread, so
 * with an injected clock everything is as reproducible as the scene. A computer that is too slow to
 * simulate it has a camera whose clock goes slower. While the camera is unplugged the scene stands
 * still, and its clock starts from 0 when it is plugged in again.
 */
final class SimulatedCamera implements Camera, TimestampReset, RegionOfInterest, Plug {
  private static final long TRANSFER_US = 1000;
  private static final int TRANSFER_EVENTS = 1024;
  private static final int BYTES_OF_EVENT = 4;
  private static final int WAITING = 1024;

  /** Time that making a scene may take at once, while others wait for the lock. */
  private static final long MOST_WORK_NANOS = 20_000_000;

  private final CameraInfo info;
  private final CameraOptions options;
  private final LongSupplier nanoTime;
  private final Sleeper sleeper;
  private final SimulatedSensor sensor;
  private final Map<Class<?>, Object> facets = new HashMap<>();
  private final Object lock = new Object();

  // Below: guarded by the lock.
  private final ArrayDeque<LiveBuffer> streams = new ArrayDeque<>();
  private final EventPacket transfer = new EventPacket(TRANSFER_EVENTS);
  private final Latencies latencies = new Latencies();
  private LiveBuffer filling;
  private boolean begun;
  private boolean pluggedIn = true;
  private boolean closed;
  private long madeUs;
  private long zeroUs;
  private long anchorNanos;
  private long lastUs = StreamNotification.NO_TIME_US;
  private boolean eventsSeen;
  private long transfers;
  private long events;
  private long handedTransfers;
  private long handedEvents;
  private long lostEarlier;
  private int mostWaiting;
  private long streamsBegun;

  SimulatedCamera(
      CameraInfo info,
      Scene<?> scene,
      CameraOptions options,
      LongSupplier nanoTime,
      Sleeper sleeper) {
    this.info = info;
    this.options = options;
    this.nanoTime = nanoTime;
    this.sleeper = sleeper;
    sensor = new SimulatedSensor(scene);
    facets.put(TimestampReset.class, this);
    facets.put(RegionOfInterest.class, this);
    facets.put(Plug.class, this);
    Optional<SimulatedBiases> biases = Optional.empty();
    if (scene instanceof TunableScene<?> tunable) {
      biases = Optional.of(new SimulatedBiases(tunable, lock, this::makeDue));
      facets.put(Biases.class, biases.get());
      facets.put(BiasSliders.class, biases.get());
    }
    facets.put(Configuration.class, new SimulatedConfiguration(info, this, biases));
  }

  @Override
  public CameraInfo info() {
    return info;
  }

  @Override
  public <F> Optional<F> facet(Class<F> facet) {
    return Optional.ofNullable(facets.get(facet)).map(facet::cast);
  }

  // ---- The sensor's side, under the lock

  private long sceneUs() {
    return Math.floorDiv(nanoTime.getAsLong() - anchorNanos, 1000);
  }

  private void begin() {
    begun = true;
    zeroUs = madeUs;
    anchorNanos = nanoTime.getAsLong() - madeUs * 1000;
    lastUs = StreamNotification.NO_TIME_US;
    int waiting = options.waitingBuffers() == 0 ? WAITING : Math.max(2, options.waitingBuffers());
    OverflowPolicy policy =
        options.whenFull() == CameraOptions.WhenFull.DROP_OLDEST
            ? OverflowPolicy.DROP_OLDEST
            : OverflowPolicy.DROP_NEWEST;
    filling =
        new LiveBuffer(
            info.geometry(), waiting, TRANSFER_EVENTS, policy, info.id() + ": nobody took them");
    streams.add(filling);
    streamsBegun++;
    filling.notified(new StreamStarted(info.geometry(), info.id()));
  }

  /** Makes the transfers whose time has come. */
  private void makeDue() {
    if (filling == null) {
      return;
    }
    long beginNanos = nanoTime.getAsLong();
    long nowUs = sceneUs();
    while (madeUs + TRANSFER_US <= nowUs && filling != null) {
      make(madeUs + TRANSFER_US);
      if (nanoTime.getAsLong() - beginNanos > MOST_WORK_NANOS) {
        // making the scene takes longer than the scene: let its clock be late by no more than this
        long lateUs = sceneUs() - madeUs - MOST_WORK_NANOS / 1000;
        anchorNanos += Math.max(0, lateUs) * 1000;
        return;
      }
    }
  }

  private void make(long untilUs) {
    transfer.clear();
    sensor.takeUntil(untilUs, zeroUs, transfer);
    madeUs = untilUs;
    if (!transfer.isEmpty()) {
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
    mostWaiting = Math.max(mostWaiting, counts.mostWaitingPackets());
    lostEarlier += counts.lost();
    filling.notified(new EndOfStream(lastUs));
    filling = null;
  }

  // ---- The consumer's side

  @Override
  public boolean next(StreamHandler handler) throws InterruptedIOException {
    while (true) {
      LiveBuffer stream;
      synchronized (lock) {
        stream = ready();
        if (stream == null && isOver()) {
          return false;
        }
      }
      if (stream == null) {
        sleep(Long.MAX_VALUE);
      } else if (stream.await(0)) {
        Measuring measuring = new Measuring(handler);
        stream.next(measuring);
        if (measuring.ended) {
          synchronized (lock) {
            streams.remove(stream);
          }
        }
        return true;
      } else {
        sleep(untilNextNanos());
      }
    }
  }

  @Override
  public boolean await(long nanos) throws InterruptedIOException {
    long untilNanos = nanoTime.getAsLong() + nanos;
    while (true) {
      synchronized (lock) {
        LiveBuffer stream = ready();
        if (stream == null ? isOver() : stream.await(0)) {
          return true;
        }
      }
      long left = untilNanos - nanoTime.getAsLong();
      if (left <= 0) {
        return false;
      }
      sleep(Math.min(left, untilNextNanos()));
    }
  }

  /** Makes what is due; the stream that the consumer is at, or null. */
  private LiveBuffer ready() {
    if (!begun && !closed && pluggedIn) {
      begin();
    }
    makeDue();
    return streams.peek();
  }

  private boolean isOver() {
    return closed || (filling == null && (pluggedIn || !options.reconnect()));
  }

  private long untilNextNanos() {
    synchronized (lock) {
      return filling == null
          ? Long.MAX_VALUE
          : Math.max(1, anchorNanos + (madeUs + TRANSFER_US) * 1000 - nanoTime.getAsLong());
    }
  }

  private void sleep(long nanos) throws InterruptedIOException {
    try {
      sleeper.sleep(nanos);
    } catch (InterruptedException interrupted) {
      Thread.currentThread().interrupt();
      throw new InterruptedIOException("interrupted while waiting for " + info.id());
    }
  }

  /** Measures how long a transfer takes from its time to the end of its work. */
  private final class Measuring implements StreamHandler {
    private final StreamHandler handler;
    private boolean ended;

    Measuring(StreamHandler handler) {
      this.handler = handler;
    }

    @Override
    public void packet(EventPacket packet) {
      int size = packet.size();
      long sentUs = Math.floorDiv(packet.lastTimeUs(), TRANSFER_US) * TRANSFER_US + TRANSFER_US;
      handler.packet(packet);
      synchronized (lock) {
        handedTransfers++;
        handedEvents += size;
        latencies.add(Math.max(0, sceneUs() - zeroUs - sentUs));
      }
    }

    @Override
    public void reading(SensorReading reading) {
      handler.reading(reading);
    }

    @Override
    public void notified(StreamNotification notification) {
      ended = notification instanceof EndOfStream;
      handler.notified(notification);
    }
  }

  // ---- What it can be asked and told

  @Override
  public CameraStatistics statistics() {
    synchronized (lock) {
      int waiting = 0;
      long lost = lostEarlier;
      if (filling != null) {
        LiveBuffer.Counts counts = filling.counts();
        waiting = counts.waitingPackets();
        mostWaiting = Math.max(mostWaiting, counts.mostWaitingPackets());
        lost += counts.lost();
      }
      return new CameraStatistics(
          transfers,
          events * BYTES_OF_EVENT,
          handedEvents,
          lost == 0 ? 0 : Math.max(1, transfers - handedTransfers - waiting),
          lost,
          0,
          0,
          waiting,
          mostWaiting,
          streamsBegun,
          latencies.ofThousandUs(500),
          latencies.ofThousandUs(999),
          latencies.longestUs());
    }
  }

  @Override
  public Optional<ClockRelation> clockRelation() {
    synchronized (lock) {
      return eventsSeen
          ? Optional.of(new ClockRelation(0, anchorNanos + zeroUs * 1000))
          : Optional.empty();
    }
  }

  @Override
  public void resetTimestamps() throws CameraProblem {
    synchronized (lock) {
      if (filling == null) {
        throw new CameraProblem(CameraProblem.Kind.GONE, info.id() + " does not run");
      }
      makeDue();
      make(Math.max(madeUs, sceneUs()));
      if (filling != null) {
        filling.notified(new Reset(Reset.Cause.CLOCK_RESTARTED, lastUs, 0));
        zeroUs = madeUs;
        lastUs = StreamNotification.NO_TIME_US;
      }
    }
  }

  @Override
  public Optional<Region> region() {
    synchronized (lock) {
      return sensor.region();
    }
  }

  @Override
  public void setRegion(Optional<Region> region) {
    region.ifPresent(
        part -> {
          if (part.left() + part.width() > info.geometry().width()
              || part.bottom() + part.height() > info.geometry().height()) {
            throw new IllegalArgumentException(part + " is not on the sensor");
          }
        });
    synchronized (lock) {
      makeDue();
      sensor.setRegion(region);
    }
  }

  @Override
  public void unplug() {
    synchronized (lock) {
      makeDue();
      pluggedIn = false;
      if (filling != null) {
        filling.notified(new DeviceLost(info.id(), lastUs));
        end();
      }
    }
    sleeper.wake();
  }

  @Override
  public void plugIn() {
    synchronized (lock) {
      boolean wasOut = !pluggedIn;
      pluggedIn = true;
      if (wasOut && begun && !closed && options.reconnect() && !sensor.isOver()) {
        begin();
      }
    }
    sleeper.wake();
  }

  @Override
  public boolean isPluggedIn() {
    synchronized (lock) {
      return pluggedIn;
    }
  }

  @Override
  public void close() {
    synchronized (lock) {
      if (!closed && filling != null) {
        end();
      }
      closed = true;
    }
    sleeper.wake();
  }
}
