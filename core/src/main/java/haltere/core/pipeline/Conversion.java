package haltere.core.pipeline;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorSample;
import haltere.core.format.ProgressListener;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.SampleCounts;
import haltere.core.format.Violation;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;

/**
 * Copies a recording, or a half-open time range of it, to a writer, optionally through a chain of
 * filters. The written file appears when it is complete.
 *
 * <p>Thread rule: everything happens on the calling thread.
 *
 * @since 0.1
 */
public final class Conversion {
  private final long fromUs;
  private final long toUs;
  private final Optional<StreamHandler> stage;
  private final ProgressListener progress;

  /**
   * A conversion.
   *
   * @param fromUs the first time to copy, on the recording's own clock; {@link Long#MIN_VALUE} for
   *     all
   * @param toUs the first time that is not copied; {@link Long#MAX_VALUE} for all
   * @param stage processes each packet in place before it is written and receives all
   *     notifications, as a filter chain; empty for a plain copy
   * @param progress receives the progress
   */
  public Conversion(
      long fromUs, long toUs, Optional<StreamHandler> stage, ProgressListener progress) {
    if (toUs < fromUs) {
      throw new IllegalArgumentException("from " + fromUs + " us to " + toUs + " us is no time");
    }
    this.fromUs = fromUs;
    this.toUs = toUs;
    this.stage = Objects.requireNonNull(stage, "stage");
    this.progress = Objects.requireNonNull(progress, "progress");
  }

  /**
   * Result of a conversion.
   *
   * @param eventsRead events of the recording within the time
   * @param eventsWritten events passed by the stage
   * @param samplesWritten frames, inertial samples and triggers that were written
   * @param samplesLeftOut samples that the written format cannot store
   * @param warnings about the recording that was read: assumptions of the reader, violations of the
   *     file, samples that were left out
   * @param losses about the recording that was written: what its format cannot hold
   */
  public record Result(
      long eventsRead,
      long eventsWritten,
      SampleCounts samplesWritten,
      SampleCounts samplesLeftOut,
      List<String> warnings,
      List<String> losses) {
    /** Copies the lists. */
    public Result {
      warnings = List.copyOf(warnings);
      losses = List.copyOf(losses);
    }
  }

  /**
   * Copies everything.
   *
   * <p>In a recording with several segments, the time range is copied from each of them.
   *
   * @param reader at its start; afterwards at its end or behind the range
   * @param writer empty; finished afterwards, not closed
   * @return the result
   * @throws InterruptedIOException if the thread is interrupted; nothing is written then
   * @throws IOException if reading or writing fails; nothing is written then
   */
  public Result run(RecordingReader reader, RecordingWriter writer) throws IOException {
    return run(reader, writer, false);
  }

  /**
   * Copies everything, as {@link #run(RecordingReader, RecordingWriter)} does.
   *
   * @param reader at its start; afterwards at its end or behind the range
   * @param writer empty; finished afterwards, not closed
   * @param whole whether a truncated or damaged recording is an error
   * @return the result
   * @throws RecordingProblem if it is damaged and has to be whole; nothing is written then
   * @throws IOException as the other
   */
  public Result run(RecordingReader reader, RecordingWriter writer, boolean whole)
      throws IOException {
    boolean last = false;
    if (reader.isSeekable() && (fromUs != Long.MIN_VALUE || toUs != Long.MAX_VALUE)) {
      last = reader.segments().size() <= 1;
    }
    if (reader.isSeekable() && fromUs != Long.MIN_VALUE) {
      reader.seek(fromUs);
    }
    ConversionSink copy = new ConversionSink(writer, last);
    long reported = 0;
    try {
      while (!copy.past && reader.next(copy)) {
        if (Thread.currentThread().isInterrupted()) {
          throw new InterruptedIOException("interrupted while converting " + reader.path());
        }
        if (reader.positionBytes() > reported) {
          reported = reader.positionBytes();
          progress.progress(reported, reader.sizeBytes());
        }
      }
    } catch (UncheckedIOException failure) {
      throw failure.getCause();
    }
    copy.end();
    RecordingJob.requireComplete(reader, whole);
    writer.finish();
    List<String> warnings = new java.util.ArrayList<>(reader.remarks());
    boolean samplesReported = !copy.samplesWritten.isEmpty() || !copy.samplesLeftOut.isEmpty();
    warnings.addAll(
        reader.violations().describe(samplesReported ? Set.of(Violation.OTHER_DATA) : Set.of()));
    if (!copy.samplesLeftOut.isEmpty()) {
      warnings.add(
          "left out, as the format that is written cannot hold this: " + copy.samplesLeftOut);
    }
    return new Result(
        copy.eventsRead,
        copy.eventsWritten,
        copy.samplesWritten,
        copy.samplesLeftOut,
        warnings,
        writer.losses());
  }

  private final class ConversionSink implements StreamHandler {
    private final RecordingWriter writer;
    private final boolean lastSegment;
    private final EventPacket part = new EventPacket(0);
    private long eventsRead;
    private long eventsWritten;
    private long lastUs = StreamNotification.NO_TIME_US;
    private SampleCounts samplesWritten = SampleCounts.NONE;
    private SampleCounts samplesLeftOut = SampleCounts.NONE;
    private boolean past;
    private boolean ended;

    ConversionSink(RecordingWriter writer, boolean lastSegment) {
      this.writer = writer;
      this.lastSegment = lastSegment;
    }

    @Override
    public void packet(EventPacket packet) {
      int from = packet.indexAtOrAfter(fromUs);
      int to = toUs == Long.MAX_VALUE ? packet.size() : packet.indexAtOrAfter(toUs, from);
      past = lastSegment && to < packet.size();
      EventPacket wanted = packet;
      if (from > 0 || to < packet.size()) {
        part.clear();
        part.append(packet, from, to);
        wanted = part;
      }
      if (wanted.isEmpty()) {
        return;
      }
      eventsRead += wanted.size();
      lastUs = wanted.lastTimeUs();
      if (stage.isPresent()) {
        stage.get().packet(wanted);
      }
      eventsWritten += wanted.size();
      try {
        writer.write(wanted);
      } catch (IOException failure) {
        throw new UncheckedIOException(failure);
      }
    }

    @Override
    public void sample(SensorSample sample) {
      if (sample.timeUs() < fromUs || sample.timeUs() >= toUs && toUs != Long.MAX_VALUE) {
        return;
      }
      stage.ifPresent(handler -> handler.sample(sample));
      try {
        if (writer.write(sample)) {
          samplesWritten = samplesWritten.plus(sample.kind());
        } else {
          samplesLeftOut = samplesLeftOut.plus(sample.kind());
        }
      } catch (IOException failure) {
        throw new UncheckedIOException(failure);
      }
    }

    @Override
    public void notified(StreamNotification notification) {
      ended |= notification instanceof EndOfStream;
      stage.ifPresent(handler -> handler.notified(notification));
    }

    /**
     * Sends the stage the end of the stream, also if the copy stops before the end of the
     * recording.
     */
    void end() {
      if (!ended) {
        notified(new EndOfStream(lastUs));
      }
    }
  }
}
