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
import haltere.core.event.SensorSample;
import haltere.core.pipeline.LiveBuffer;
import haltere.core.playback.Sleeper;
import haltere.core.simulation.Scene;
import haltere.core.simulation.internal.sensor.TunableScene;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.io.InterruptedIOException;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.LongSupplier;

/**
 * A scene that behaves as a camera: see {@link SimulatedTransfers}. In real time a {@link
 * Heartbeat} creates the events independent of the consumer; with an injected clock the consumer's
 * thread creates them on demand, so that the stream is reproducible.
 */
final class SimulatedCamera implements Camera, TimestampReset, RegionOfInterest, Plug {
  private static final int BYTES_OF_EVENT = 4;

  private final CameraInfo info;
  private final SimulatedTransfers transfers;
  private final LongSupplier nanoTime;
  private final Sleeper sleeper;
  private final Optional<Heartbeat> heartbeat;
  private final Map<Class<?>, Object> facets = new HashMap<>();
  private final Measuring measuring = new Measuring();
  private volatile Throwable failure;

  /** A camera in real time. */
  static SimulatedCamera live(CameraInfo info, Scene<?> scene, CameraOptions options) {
    return new SimulatedCamera(info, scene, options, System::nanoTime, Sleeper.real(), true);
  }

  /** A camera whose time advances while its consumer waits. */
  static SimulatedCamera stepped(
      CameraInfo info,
      Scene<?> scene,
      CameraOptions options,
      LongSupplier nanoTime,
      Sleeper sleeper) {
    return new SimulatedCamera(info, scene, options, nanoTime, sleeper, false);
  }

  private SimulatedCamera(
      CameraInfo info,
      Scene<?> scene,
      CameraOptions options,
      LongSupplier nanoTime,
      Sleeper sleeper,
      boolean live) {
    this.info = info;
    this.nanoTime = nanoTime;
    this.sleeper = sleeper;
    transfers = new SimulatedTransfers(info, scene, options, nanoTime);
    heartbeat =
        live ? Optional.of(new Heartbeat(transfers, info.id(), this::fail)) : Optional.empty();
    facets.put(TimestampReset.class, this);
    facets.put(RegionOfInterest.class, this);
    facets.put(Plug.class, this);
    Optional<SimulatedBiases> biases = Optional.empty();
    if (scene instanceof TunableScene<?> tunable) {
      biases = Optional.of(new SimulatedBiases(tunable, transfers));
      facets.put(Biases.class, biases.get());
      facets.put(BiasSliders.class, biases.get());
    }
    facets.put(Configuration.class, new SimulatedConfiguration(info, this, biases));
  }

  private void fail(Throwable thrown) {
    failure = thrown;
    close();
  }

  @Override
  public CameraInfo info() {
    return info;
  }

  @Override
  public <F> Optional<F> facet(Class<F> facet) {
    return Optional.ofNullable(facets.get(facet)).map(facet::cast);
  }

  // ---- The consumer's side

  @Override
  public boolean next(StreamHandler handler) throws InterruptedIOException {
    await(Long.MAX_VALUE);
    LiveBuffer stream = transfers.stream();
    if (stream == null) {
      if (failure != null) {
        throw new IllegalStateException(info.id() + ": its scene failed", failure);
      }
      return false;
    }
    measuring.handler = handler;
    measuring.ended = false;
    stream.next(measuring);
    if (measuring.ended) {
      transfers.taken(stream);
    }
    return true;
  }

  @Override
  public boolean await(long nanos) throws InterruptedIOException {
    long beginNanos = nanoTime.getAsLong();
    while (true) {
      resume();
      LiveBuffer stream = transfers.stream();
      long left = nanos == Long.MAX_VALUE ? nanos : nanos - (nanoTime.getAsLong() - beginNanos);
      if (stream != null && heartbeat.isPresent()) {
        return stream.await(left);
      }
      if (stream == null ? transfers.isTaken() : stream.await(0)) {
        return true;
      }
      if (left <= 0) {
        return false;
      }
      sleep(Math.min(left, transfers.untilNextNanos()));
    }
  }

  /** Starts due transfers. */
  private void resume() {
    transfers.start();
    if (heartbeat.isPresent()) {
      heartbeat.get().start();
    } else {
      transfers.makeDue();
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
    private final Latencies latencies = new Latencies();
    private StreamHandler handler;
    private boolean ended;
    private long handedTransfers;
    private long handedEvents;

    @Override
    public void packet(EventPacket packet) {
      int size = packet.size();
      long transferUs = SimulatedTransfers.TRANSFER_US;
      long sentUs = Math.floorDiv(packet.lastTimeUs(), transferUs) * transferUs + transferUs;
      handler.packet(packet);
      long tookUs = Math.max(0, transfers.sinceUs(sentUs));
      synchronized (this) {
        handedTransfers++;
        handedEvents += size;
        latencies.add(tookUs);
      }
    }

    @Override
    public void sample(SensorSample sample) {
      handler.sample(sample);
    }

    @Override
    public void notified(StreamNotification notification) {
      ended = notification instanceof EndOfStream;
      handler.notified(notification);
    }

    synchronized CameraStatistics with(SimulatedTransfers.TransferCounts counts) {
      return new CameraStatistics(
          counts.transfers(),
          counts.events() * BYTES_OF_EVENT,
          handedEvents,
          counts.lost() == 0
              ? 0
              : Math.max(1, counts.transfers() - handedTransfers - counts.waiting()),
          counts.lost(),
          counts.timesBehind(),
          0,
          counts.waiting(),
          counts.maxWaiting(),
          counts.streams(),
          latencies.ofThousandUs(500),
          latencies.ofThousandUs(999),
          latencies.longestUs());
    }
  }

  // ---- State and settings

  @Override
  public CameraStatistics statistics() {
    return measuring.with(transfers.counts());
  }

  @Override
  public Optional<ClockRelation> clockRelation() {
    return transfers.zeroNanos().map(nanos -> new ClockRelation(0, nanos));
  }

  @Override
  public void resetTimestamps() throws CameraProblem {
    transfers.resetTimestamps();
  }

  @Override
  public Optional<Region> region() {
    return transfers.region();
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
    transfers.setRegion(region);
  }

  @Override
  public void unplug() {
    transfers.unplug();
    wake();
  }

  @Override
  public void plugIn() {
    transfers.plugIn();
    wake();
  }

  @Override
  public boolean isPluggedIn() {
    return transfers.isPluggedIn();
  }

  @Override
  public void close() {
    transfers.close();
    wake();
  }

  private void wake() {
    heartbeat.ifPresent(Heartbeat::wake);
    sleeper.wake();
  }
}
