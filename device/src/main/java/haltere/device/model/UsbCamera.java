package haltere.device.model;

import haltere.core.camera.Camera;
import haltere.core.camera.CameraInfo;
import haltere.core.camera.CameraOptions;
import haltere.core.camera.CameraProblem;
import haltere.core.camera.CameraStatistics;
import haltere.core.camera.ClockRelation;
import haltere.core.stream.DeviceLost;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import haltere.device.usb.ReceivedBuffers;
import haltere.device.usb.UsbTransport;
import java.io.InterruptedIOException;
import java.util.ArrayDeque;
import java.util.Optional;

/**
 * A camera on USB. The consumer's thread starts it, decodes its data, and reconnects it after it
 * was unplugged.
 */
final class UsbCamera implements Camera {
  /** Finds and opens a camera that was plugged in again. */
  interface Finder {
    /** An open and claimed transport, or empty if the camera is absent. */
    Optional<UsbTransport> find() throws CameraProblem;
  }

  private enum CameraState {
    READY,
    STREAMING,
    AWAY,
    OVER
  }

  /**
   * The current link and the counts of earlier ones.
   *
   * @param link null while the camera is unplugged
   * @param earlier sums
   */
  private record Connection(CameraLink link, CameraStatistics earlier) {}

  private final CameraDriver driver;
  private final CameraOptions options;
  private final Finder finder;
  private final SearchSchedule schedule;
  private final LatencyHistogram latency = new LatencyHistogram();
  private final ClockWatch clock = new ClockWatch();

  /** Guards the link: starting, reconnecting and closing exclude each other. */
  private final Object lifecycle = new Object();

  private volatile boolean closing;
  private volatile Connection connection;
  private volatile long streams;
  private volatile long events;

  // state of the consumer
  private final ArrayDeque<StreamNotification> notifications = new ArrayDeque<>();
  private CameraState state = CameraState.READY;
  private StreamAssembly assembly;
  private ReceivedBuffers streaming;

  /**
   * A configured camera.
   *
   * @param driver of the camera
   * @param link of the driver
   * @param options of its stream
   * @param finder finds it again
   * @param schedule times of the search; closed with this
   */
  UsbCamera(
      CameraDriver driver,
      CameraLink link,
      CameraOptions options,
      Finder finder,
      SearchSchedule schedule) {
    this.driver = driver;
    connection = new Connection(link, CameraStatistics.NONE);
    this.options = options;
    this.finder = finder;
    this.schedule = schedule;
  }

  @Override
  public CameraInfo info() {
    return driver.info();
  }

  @Override
  public <F> Optional<F> facet(Class<F> facet) {
    return Optional.ofNullable(driver.facets().get(facet)).map(facet::cast);
  }

  @Override
  public Optional<ClockRelation> clockRelation() {
    return clock.relation();
  }

  // ---- The consumer's side

  @Override
  public boolean next(StreamHandler handler) throws CameraProblem, InterruptedIOException {
    boolean prepared = false;
    while (!prepared) {
      prepared = prepare(Long.MAX_VALUE);
    }
    if (!notifications.isEmpty()) {
      handler.notified(notifications.remove());
      return true;
    }
    if (state == CameraState.OVER) {
      return false;
    }
    int handed = assembly.handOver(handler);
    events += handed;
    return true;
  }

  @Override
  public boolean await(long nanos) throws CameraProblem, InterruptedIOException {
    return prepare(nanos);
  }

  /** Decodes until a packet, notification or sample is pending; false after a timeout. */
  private boolean prepare(long nanos) throws CameraProblem, InterruptedIOException {
    long end = System.nanoTime() + Math.min(nanos, Long.MAX_VALUE / 4);
    while (notifications.isEmpty() && state != CameraState.OVER) {
      if (closing && state != CameraState.STREAMING) {
        state = CameraState.OVER;
      } else if (state == CameraState.READY) {
        begin();
      } else if (state == CameraState.AWAY) {
        if (!searchAgain(end - System.nanoTime())) {
          return false;
        }
      } else if (assembly.isReady()) {
        return true;
      } else {
        assembly.release();
        if (!assembly.advance(end - System.nanoTime()) && !endStream()) {
          return false;
        }
      }
    }
    return true;
  }

  /** Handles the end of a stream; false after a timeout. */
  private boolean endStream() {
    if (!streaming.isEnded() && !streaming.isAtEndOfDevice()) {
      return false;
    }
    if (!streaming.droppedLast().isEmpty()) {
      assembly.skip(streaming.droppedLast());
    }
    assembly.reportLoss(StreamNotification.NO_TIME_US);
    assembly.drainTo(notifications);
    if (streaming.isEnded()) {
      notifications.add(new EndOfStream(assembly.lastUs()));
      state = CameraState.OVER;
    } else {
      endAfterLoss();
    }
    return true;
  }

  private void endAfterLoss() {
    CameraInfo info = info();
    notifications.add(
        new DeviceLost(
            info.model() + " " + info.serial() + " (" + info.id() + ")", assembly.lastUs()));
    notifications.add(new EndOfStream(assembly.lastUs()));
    closeLink();
    if (options.reconnect()) {
      state = CameraState.AWAY;
      schedule.begin();
    } else {
      state = CameraState.OVER;
    }
  }

  private void begin() throws CameraProblem {
    synchronized (lifecycle) {
      if (closing) {
        return;
      }
      CameraLink started = connection.link;
      streaming = started.buffers();
      assembly =
          new StreamAssembly(
              streaming,
              started.decoder(),
              started::recover,
              info().id(),
              options.samples(),
              latency,
              clock);
      clock.restart();
      started.start();
      streams++;
    }
    state = CameraState.STREAMING;
    notifications.add(new StreamStarted(geometry(), info().model() + " " + info().serial()));
  }

  /** Searches the camera when an attempt is due; false after a timeout. */
  private boolean searchAgain(long nanos) throws InterruptedIOException {
    try {
      if (!schedule.await(nanos)) {
        return false;
      }
    } catch (InterruptedException interrupted) {
      Thread.currentThread().interrupt();
      throw new InterruptedIOException("interrupted while waiting for " + info().id());
    }
    look();
    return true;
  }

  private void look() {
    synchronized (lifecycle) {
      if (closing) {
        return;
      }
      try {
        Optional<UsbTransport> found = finder.find();
        if (found.isPresent()) {
          CameraLink fresh = new CameraLink(driver, found.get(), options);
          connection = new Connection(fresh, connection.earlier);
          begin();
          schedule.end();
        }
      } catch (CameraProblem ignored) {
        // just plugged in, it may not answer yet, or access may not be granted yet
        if (connection.link != null) {
          connection.link.buffers().close();
        }
        closeLink();
      }
    }
  }

  // ---- Any thread

  @Override
  public void close() {
    closing = true;
    schedule.close();
    CameraLink now = connection.link;
    if (now != null) {
      now.buffers().end(); // wakes the consumer in any state of the bus
    }
    closeLink();
  }

  private void closeLink() {
    synchronized (lifecycle) {
      CameraLink old = connection.link;
      if (old != null) {
        old.close();
        connection = new Connection(null, statistics());
      }
    }
  }

  @Override
  public CameraStatistics statistics() {
    Connection now = connection;
    CameraStatistics earlier = now.earlier;
    ReceivedBuffers.BufferCounts counts =
        now.link == null ? ReceivedBuffers.BufferCounts.NONE : now.link.buffers().counts();
    return new CameraStatistics(
        earlier.transfers() + counts.transfers(),
        earlier.bytes() + counts.bytes(),
        events,
        earlier.lostTransfers() + counts.lostTransfers(),
        earlier.lostEvents() + counts.lostEvents(),
        earlier.brokenTransfers() + counts.brokenTransfers(),
        earlier.unknownWords() + (now.link == null ? 0 : now.link.decoder().unknownWords()),
        counts.waiting(),
        Math.max(earlier.maxWaiting(), counts.maxWaiting()),
        streams,
        latency.quantileUs(0.5),
        latency.quantileUs(0.999),
        latency.longestUs());
  }

  @Override
  public String toString() {
    return info().id();
  }
}
