package haltere.core.pipeline;

import haltere.core.camera.Camera;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.event.SensorSample;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingWriter;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.internal.Daemon;
import haltere.core.stream.internal.Reason;
import java.io.Closeable;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.LongSupplier;
import java.util.function.Supplier;

/**
 * Records the stream of a camera in parts. A new part starts at the maximum size, when an unplugged
 * camera is back, and at a reset of its clock, so that a part has one clock. Each event is in one
 * part. The recording ends with a complete file before the disk is full. Parts are named {@code
 * out.aedat4}, {@code out-2.aedat4}, {@code out-3.aedat4}.
 *
 * <p>A disk that is too slow loses events, which are counted, and never blocks the stream: see
 * {@link Recorder}.
 *
 * <p>Thread rule: one thread passes the stream and ends it; the rest may be called from any.
 *
 * @since 0.1
 */
public final class SessionRecorder implements StreamHandler, Closeable {
  /** Creates the writer of a part. */
  @FunctionalInterface
  public interface WriterFactory {
    /**
     * Starts a file.
     *
     * @param file where it is
     * @param metadata lines for its header
     * @return a writer
     * @throws IOException if it cannot be written
     */
    RecordingWriter create(Path file, Map<String, String> metadata) throws IOException;
  }

  /**
   * Limits of a recording.
   *
   * @param partBytes maximum size of a part, {@link Long#MAX_VALUE} for none
   * @param keepFreeBytes free space of the disk at which the recording ends
   */
  public record Limits(long partBytes, long keepFreeBytes) {
    /** The smallest size of a part: one packet of events and the file's own lines. */
    public static final long MIN_PART_BYTES = 1 << 20;

    /** One part, and 256 MB of the disk left. */
    public static final Limits DEFAULT = new Limits(Long.MAX_VALUE, 256_000_000);

    /** Checks the sizes. */
    public Limits {
      if (partBytes < MIN_PART_BYTES || keepFreeBytes < 0) {
        throw new IllegalArgumentException(
            "a part has at least " + MIN_PART_BYTES + " bytes, not " + partBytes);
      }
    }
  }

  /**
   * A file of the session.
   *
   * @param file where it is
   * @param report what is in it
   */
  public record Part(Path file, RecorderReport report) {}

  /** Upper bound of the bytes per event in any format, including overhead. */
  private static final long EVENT_BYTES = 20;

  private static final long FILE_BYTES = 128 * 1024;
  private static final int PACKETS_BETWEEN_CHECKS = 128;
  private static final long EVENTS_BETWEEN_CHECKS = 200_000;

  private record Open(Path file, Recorder recorder) {}

  private final Path out;
  private final SensorGeometry geometry;
  private final WriterFactory writers;
  private final Limits limits;
  private final Supplier<Map<String, String>> header;
  private final LongSupplier freeBytes;
  private final List<Open> parts = new ArrayList<>();
  private final List<Future<RecorderReport>> finished = new ArrayList<>();
  private final ExecutorService finisher =
      Executors.newSingleThreadExecutor(work -> Daemon.thread(work, "haltere-session"));
  private Open current;
  private int packetsSinceCheck = PACKETS_BETWEEN_CHECKS;
  private long eventsSinceCheck;
  private volatile long afterEnd;
  private volatile String endedEarly = "";

  /**
   * A session without a file; the first part starts with the first event.
   *
   * @param out the first part
   * @param geometry sensor of the events
   * @param writers create the writers of the parts
   * @param limits sizes
   * @param header lines for the header of each part, asked when it starts, on the thread of the
   *     stream
   * @param freeBytes free space where the parts go, see {@link #freeBytes(Path)}
   */
  public SessionRecorder(
      Path out,
      SensorGeometry geometry,
      WriterFactory writers,
      Limits limits,
      Supplier<Map<String, String>> header,
      LongSupplier freeBytes) {
    this.out = Objects.requireNonNull(out, "out");
    this.geometry = Objects.requireNonNull(geometry, "geometry");
    this.writers = Objects.requireNonNull(writers, "writers");
    this.limits = Objects.requireNonNull(limits, "limits");
    this.header = Objects.requireNonNull(header, "header");
    this.freeBytes = Objects.requireNonNull(freeBytes, "freeBytes");
  }

  /**
   * Checks that the disk has more free space than {@link Limits#keepFreeBytes}.
   *
   * @throws RecordingProblem if not, with a remedy
   */
  public void checkSpace() throws RecordingProblem {
    long free = freeBytes.getAsLong();
    if (free < limits.keepFreeBytes()) {
      throw new RecordingProblem(
          out,
          "its disk has "
              + free / 1_000_000
              + " MB left, and "
              + limits.keepFreeBytes() / 1_000_000
              + " MB must stay free (--keep-free); make room, or record to another disk");
    }
  }

  /**
   * Free space of the disk of a file.
   *
   * @param file a file in a folder that exists
   * @return queries the system at each call; {@link Long#MAX_VALUE} if it does not state it
   */
  public static LongSupplier freeBytes(Path file) {
    Path folder = file.toAbsolutePath().getParent();
    return () -> {
      try {
        return Files.getFileStore(folder).getUsableSpace();
      } catch (IOException ignored) {
        return Long.MAX_VALUE;
      }
    };
  }

  /**
   * The name of a part.
   *
   * @param out the first part
   * @param number from 1
   * @return {@code out.aedat4}, {@code out-2.aedat4}, ...
   */
  public static Path part(Path out, int number) {
    if (number == 1) {
      return out;
    }
    return extended(out, "-" + number);
  }

  /**
   * A file beside another one.
   *
   * @param file the other one
   * @param added what its name has more, before the ending
   * @return {@code out.x.aedat4} for {@code out.aedat4} and {@code .x}
   */
  public static Path extended(Path file, String added) {
    String name = file.getFileName().toString();
    int dot = name.lastIndexOf('.');
    int end = dot > 0 ? dot : name.length();
    return file.resolveSibling(name.substring(0, end) + added + name.substring(end));
  }

  /**
   * A recorder of a camera, which says in its header what the camera and the chain are set to.
   *
   * @param out the first part
   * @param camera open
   * @param chain the chain as JSON, if there is one
   * @param writers makes the files
   * @param limits how much is recorded
   * @return a recorder without any file yet
   * @throws IOException if the disk has less free space than is to stay
   */
  public static SessionRecorder ofCamera(
      Path out,
      Camera camera,
      Supplier<Optional<String>> chain,
      WriterFactory writers,
      Limits limits)
      throws IOException {
    SessionRecorder session =
        new SessionRecorder(
            out,
            camera.geometry(),
            writers,
            limits,
            new CameraHeader(camera, chain, System::nanoTime, Clock.systemUTC()),
            freeBytes(out));
    session.checkSpace();
    return session;
  }

  // ---- The stream's side

  /**
   * Takes a copy of a packet.
   *
   * @param packet borrowed and not changed
   * @throws UncheckedIOException if a part could not be started or written
   */
  @Override
  public void packet(EventPacket packet) {
    if (packet.isEmpty()) {
      return;
    }
    if (!endedEarly.isEmpty()) {
      afterEnd = afterEnd + packet.size();
      return;
    }
    try {
      if (current != null && isFull(packet.size())) {
        endPart();
      }
      if (current == null && !checkDisk()) {
        afterEnd = afterEnd + packet.size();
        return;
      }
      if (current == null) {
        startPart();
      }
    } catch (IOException problem) {
      endedEarly = Reason.of(problem);
      throw new UncheckedIOException(problem);
    }
    current.recorder().packet(packet);
    eventsSinceCheck += packet.size();
    if (++packetsSinceCheck >= PACKETS_BETWEEN_CHECKS
        || eventsSinceCheck >= EVENTS_BETWEEN_CHECKS) {
      checkDisk();
    }
  }

  private boolean isFull(int more) throws IOException {
    if (limits.partBytes() == Long.MAX_VALUE) {
      return false;
    }
    RecorderReport report = current.recorder().report();
    long coming = report.received() - report.written() - report.lost() + more;
    long there = Files.exists(current.file()) ? Files.size(current.file()) : 0;
    return there + coming * EVENT_BYTES + FILE_BYTES > limits.partBytes() && report.received() > 0;
  }

  /** Ends the session if the disk gets full; true if it continues. */
  private boolean checkDisk() {
    packetsSinceCheck = 0;
    eventsSinceCheck = 0;
    long free = freeBytes.getAsLong();
    if (free >= limits.keepFreeBytes()) {
      return true;
    }
    endedEarly =
        "the disk of "
            + out
            + " has only "
            + free / 1_000_000
            + " MB left, so the recording ended; "
            + (current == null && parts().isEmpty()
                ? "nothing was written"
                : "it is complete up to there");
    endPart();
    return false;
  }

  private void startPart() throws IOException {
    int number;
    synchronized (parts) {
      number = parts.size() + 1;
    }
    Path file = part(out, number);
    RecordingWriter writer = writers.create(file, header.get());
    current = new Open(file, new Recorder(writer, geometry, OverflowPolicy.DROP_NEWEST));
    synchronized (parts) {
      parts.add(current);
    }
  }

  private void endPart() {
    if (current != null) {
      finished.add(finisher.submit(current.recorder()::finish));
      current = null;
    }
  }

  @Override
  public void sample(SensorSample sample) {
    if (current != null) {
      current.recorder().sample(sample);
    }
  }

  @Override
  public void notified(StreamNotification notification) {
    boolean clockRestarted =
        notification instanceof Reset reset && reset.cause() == Reset.Cause.CLOCK_RESTARTED;
    if (clockRestarted || notification instanceof EndOfStream) {
      endPart();
    } else if (current != null) {
      current.recorder().notified(notification);
    }
  }

  // ---- The end

  /**
   * Completes all parts.
   *
   * @return the parts in order
   * @throws IOException if one could not be completed
   */
  public List<Part> finish() throws IOException {
    endPart();
    finisher.shutdown();
    IOException problem = null;
    for (Future<RecorderReport> part : finished) {
      try {
        part.get();
      } catch (ExecutionException failed) {
        problem = failed.getCause() instanceof IOException cause ? cause : new IOException(failed);
      } catch (InterruptedException ignored) {
        Thread.currentThread().interrupt();
        problem = new java.io.InterruptedIOException("interrupted while the recording was ended");
      }
    }
    if (problem != null) {
      throw problem;
    }
    return parts();
  }

  /** Ends the session; received data are written. */
  @Override
  public void close() throws IOException {
    if (!finisher.isShutdown()) {
      finish();
    }
  }

  /**
   * The parts so far.
   *
   * @return in order, with what is in them now
   */
  public List<Part> parts() {
    synchronized (parts) {
      return parts.stream().map(part -> new Part(part.file(), part.recorder().report())).toList();
    }
  }

  /**
   * Reason for an early end of the session.
   *
   * @return a line for users, or empty
   */
  public Optional<String> endedEarly() {
    return Optional.of(endedEarly).filter(line -> !line.isEmpty());
  }

  /**
   * Events that came, whether or not they were written.
   *
   * @return a count
   */
  public long received() {
    return afterEnd + parts().stream().mapToLong(part -> part.report().received()).sum();
  }

  /**
   * Events that are in the parts.
   *
   * @return a count
   */
  public long written() {
    return parts().stream().mapToLong(part -> part.report().written()).sum();
  }

  /**
   * Events that came after an early end.
   *
   * @return a count
   */
  public long afterEnd() {
    return afterEnd;
  }
}
