package haltere.core.pipeline;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.event.SensorSample;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingWriter;
import haltere.core.format.SampleCounts;
import haltere.core.format.WriteOptions;
import haltere.core.format.internal.aedat4.Aedat4Compression;
import haltere.core.format.internal.aedat4.Aedat4Writer;
import haltere.core.stream.DataLost;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.internal.Daemon;
import haltere.core.stream.internal.Reason;
import java.io.Closeable;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * Records a stream to disk while it is played or captured. Packets are copied to a fixed number of
 * packets ({@value #QUEUE_PACKETS} of {@value #PACKET_EVENTS} events, 25 MB), and a separate thread
 * writes them, so a slow disk blocks no other thread until they are full. Then the policy decides:
 * {@link OverflowPolicy#BLOCK} waits (for recordings and scenes, which can wait), {@link
 * OverflowPolicy#DROP_NEWEST} drops, and counts what it drops. If the writer supports it, events
 * reach the file within {@value #FLUSH_MS} ms; {@link #inPlace} makes a file that is then also
 * readable if the program is killed.
 *
 * <p>A jump of playback ends the recording: events after a {@code Reset(REWIND)} or {@code
 * Reset(SEEK)} that follows events, or after the end of the stream, are counted but not written.
 *
 * <p>A disk that fails ends the recording: the next call with a packet throws, and so do {@link
 * #finish()} and {@link #close()}.
 *
 * <p>Thread rule: one thread passes the stream; everything else may be called from any thread.
 *
 * @since 0.1
 */
public final class Recorder implements StreamHandler, Closeable {
  /** Events of a packet that waits for the disk. */
  public static final int PACKET_EVENTS = 8192;

  /** Maximum number of packets that wait for the disk. */
  public static final int QUEUE_PACKETS = 256;

  /** Milliseconds after which an incomplete packet is written. */
  public static final int FLUSH_MS = 100;

  private static final int MAX_GAPS = 100;
  private static final Duration TIMEOUT = Duration.ofSeconds(10);

  private final RecordingWriter writer;
  private final LiveBuffer buffer;
  private final Duration timeout;
  private final Thread thread;

  // The producer's.
  private long received;
  private volatile StreamNotification stoppedBy;
  private volatile long eventsAfterStop;

  // The writing thread's.
  private final List<DataLost> gaps = new ArrayList<>();
  private long waitingNanos;
  private volatile SampleCounts samplesLeftOut = SampleCounts.NONE;
  private volatile long handed;
  private volatile long written;
  private volatile Throwable failure;
  private volatile boolean complete;
  private volatile boolean finished;
  private volatile boolean endRequested;

  /**
   * Starts a recording.
   *
   * @param writer owned and closed from now on
   * @param geometry sensor of the events
   * @param policy reaction when the disk does not keep up
   */
  public Recorder(RecordingWriter writer, SensorGeometry geometry, OverflowPolicy policy) {
    this(writer, geometry, policy, QUEUE_PACKETS, TIMEOUT);
  }

  Recorder(
      RecordingWriter writer,
      SensorGeometry geometry,
      OverflowPolicy policy,
      int queuePackets,
      Duration timeout) {
    this.writer = Objects.requireNonNull(writer, "writer");
    this.timeout = Objects.requireNonNull(timeout, "patience");
    buffer =
        LiveBuffer.coalescing(
            geometry,
            (queuePackets - 1) * PACKET_EVENTS,
            PACKET_EVENTS,
            policy,
            "the recorder's disk");
    thread = Daemon.thread(this::work, "haltere-recorder");
    thread.start();
  }

  /**
   * Starts a recording to an AEDAT-4 file that is readable, up to its last whole packet, from its
   * first moment on, even if the program is killed.
   *
   * @param file its path
   * @param options about the events
   * @param policy reaction when the disk does not keep up
   * @return a recorder
   * @throws IOException if the file cannot be written
   */
  public static Recorder inPlace(Path file, WriteOptions options, OverflowPolicy policy)
      throws IOException {
    return new Recorder(
        Aedat4Writer.createInPlace(file, options, Aedat4Compression.LZ4),
        options.geometry(),
        policy);
  }

  // ---- The stream's side

  /**
   * Records a copy of a packet.
   *
   * @param packet borrowed and not changed
   * @throws UncheckedIOException if an earlier packet could not be written
   */
  @Override
  public void packet(EventPacket packet) {
    if (stoppedBy != null) {
      eventsAfterStop += packet.size();
      return;
    }
    if (failure != null) {
      throw new UncheckedIOException(problem());
    }
    received += packet.size();
    buffer.packet(packet);
  }

  /** {@inheritDoc} It is written if the format holds its kind, and counted if not. */
  @Override
  public void sample(SensorSample sample) {
    if (stoppedBy == null && failure == null) {
      buffer.sample(sample);
    }
  }

  @Override
  public void notified(StreamNotification notification) {
    if (stoppedBy != null) {
      return;
    }
    if (received > 0 && endsRecording(notification)) {
      stoppedBy = notification;
    } else if (notification instanceof Reset || notification instanceof DataLost) {
      buffer.notified(notification);
    }
  }

  private static boolean endsRecording(StreamNotification notification) {
    return notification instanceof EndOfStream
        || (notification instanceof Reset reset
            && (reset.cause() == Reset.Cause.REWIND || reset.cause() == Reset.Cause.SEEK));
  }

  // ---- The writing thread

  private void work() {
    try (writer) {
      while (buffer.next(disk)) {
        if (!buffer.await(untilFlush())) {
          flush();
        }
      }
      flush();
      if (complete) {
        writer.finish();
        finished = true;
      }
    } catch (IOException | RuntimeException | Error thrown) {
      failure = thrown;
    } finally {
      buffer.close();
    }
  }

  private long untilFlush() {
    return written == handed
        ? Long.MAX_VALUE
        : waitingNanos + Duration.ofMillis(FLUSH_MS).toNanos() - System.nanoTime();
  }

  private void flush() throws IOException {
    writer.writeThrough();
    written = handed;
  }

  private final StreamHandler disk =
      new StreamHandler() {
        @Override
        public void packet(EventPacket packet) {
          if (written == handed) {
            waitingNanos = System.nanoTime();
          }
          try {
            writer.write(packet);
            handed += packet.size();
            if (untilFlush() <= 0) {
              flush();
            }
          } catch (IOException thrown) {
            throw new UncheckedIOException(thrown);
          }
        }

        @Override
        public void sample(SensorSample sample) {
          try {
            if (!writer.write(sample)) {
              samplesLeftOut = samplesLeftOut.plus(sample.kind());
            }
          } catch (IOException thrown) {
            throw new UncheckedIOException(thrown);
          }
        }

        @Override
        public void notified(StreamNotification notification) {
          if (notification instanceof DataLost gap) {
            synchronized (gaps) {
              if (gaps.size() < MAX_GAPS) {
                gaps.add(gap);
              }
            }
          }
        }
      };

  // ---- The end

  /**
   * Writes waiting packets and completes the file. Waits as long as the disk makes progress.
   *
   * @return the report
   * @throws IOException if something could not be written, or the disk makes no progress for ten
   *     seconds; {@link #report()} then states the content of the file
   * @throws IllegalStateException if it was closed before
   */
  public RecorderReport finish() throws IOException {
    if (!complete && !thread.isAlive() && failure == null) {
      throw new IllegalStateException("the recording has been closed");
    }
    complete = true;
    end();
    if (failure != null) {
      throw problem();
    }
    if (!finished) {
      throw new InterruptedIOException("interrupted while the recording was ended");
    }
    return report();
  }

  /**
   * Ends the recording. If it was not finished, waiting packets are still written, but the writer
   * does not finish: a file in place can be read, an atomic one does not appear.
   *
   * @throws IOException as {@link #finish()}, unless it was thrown there
   */
  @Override
  public void close() throws IOException {
    if (!endRequested) {
      end();
      if (failure != null) {
        throw problem();
      }
    }
  }

  private void end() throws IOException {
    endRequested = true;
    buffer.notified(new EndOfStream(StreamNotification.NO_TIME_US));
    boolean interrupted = false;
    boolean waitAgain;
    do {
      long before = handed;
      try {
        thread.join(timeout.toMillis());
        waitAgain = handed != before;
      } catch (InterruptedException e) {
        interrupted = true;
        stop();
        waitAgain = true;
      }
    } while (thread.isAlive() && waitAgain);
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
    if (thread.isAlive()) {
      stop();
      throw new IOException(
          "the disk has written nothing for "
              + timeout.toSeconds()
              + " s; the recording has its first "
              + written
              + " events");
    }
  }

  /** Drops waiting packets; a thread that is blocked by the disk may stay blocked. */
  private void stop() {
    complete = false;
    buffer.close();
    thread.interrupt();
  }

  private IOException problem() {
    Throwable cause =
        failure instanceof UncheckedIOException wrapped ? wrapped.getCause() : failure;
    String what = cause instanceof RecordingProblem ? "" : "the recording could not be written: ";
    return new IOException(what + Reason.of(cause), cause);
  }

  /**
   * The report so far.
   *
   * @return a snapshot; complete once {@link #finish()} or {@link #close()} is done
   */
  public RecorderReport report() {
    LiveBuffer.Counts counts = buffer.counts();
    List<DataLost> reportedGaps;
    synchronized (gaps) {
      reportedGaps = List.copyOf(gaps);
    }
    boolean failed = failure != null;
    return new RecorderReport(
        counts.in(),
        written,
        counts.lost() + (failed ? counts.out() - written : 0),
        eventsAfterStop,
        counts.waitingPackets(),
        samplesLeftOut,
        buffer.samplesLost(),
        reportedGaps,
        Optional.ofNullable(stoppedBy),
        failed ? Optional.of(problem().getMessage()) : Optional.empty());
  }
}
