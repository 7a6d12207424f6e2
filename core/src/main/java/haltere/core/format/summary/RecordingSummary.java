package haltere.core.format.summary;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.event.SensorSample;
import haltere.core.format.ProgressListener;
import haltere.core.format.RecordingReader;
import haltere.core.format.SampleCounts;
import haltere.core.format.TimeSegment;
import haltere.core.format.Violation;
import haltere.core.stream.DataLost;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Set;

/**
 * The summary of a recording from one pass.
 *
 * <p>Thread rule: immutable.
 *
 * @param format name of its format
 * @param geometry its sensor
 * @param events number of events
 * @param on number of ON events
 * @param off number of OFF events
 * @param firstUs time of the first event in microseconds, 0 without events
 * @param lastUs time of the last event in microseconds, 0 without events
 * @param durationS total duration of all segments in seconds
 * @param meanRateEps events per second over that duration, 0 if it is 0
 * @param peakRateEps maximum event rate in a bin of 10 ms, in events per second; the bins are
 *     contiguous from the first event of each segment
 * @param timestampsMonotonic whether no event of the file is earlier than the one before it
 * @param gaps losses that the recording itself reports, and silences of the whole sensor of at
 *     least {@link #SILENCE_US}; the first {@link #MAX_LISTED}
 * @param segments sections between which the clock goes back; the first {@link #MAX_LISTED}
 * @param samples numbers of frames, inertial samples and triggers
 * @param warnings for users: assumptions of the reader, violations and skipped data
 * @since 0.1
 */
public record RecordingSummary(
    String format,
    SensorGeometry geometry,
    long events,
    long on,
    long off,
    long firstUs,
    long lastUs,
    double durationS,
    double meanRateEps,
    double peakRateEps,
    boolean timestampsMonotonic,
    List<Gap> gaps,
    List<TimeSegment> segments,
    SampleCounts samples,
    List<String> warnings) {
  /** Minimum silence of a whole sensor that is a gap: any sensor's noise is denser than that. */
  public static final long SILENCE_US = 1_000_000;

  /** Maximum number of listed gaps and segments; the warnings report more. */
  public static final int MAX_LISTED = 10_000;

  private static final long PEAK_US = 10_000;

  /** Checks the values and copies the lists. */
  public RecordingSummary {
    Objects.requireNonNull(format, "format");
    Objects.requireNonNull(geometry, "geometry");
    Objects.requireNonNull(samples, "samples");
    gaps = List.copyOf(gaps);
    segments = List.copyOf(segments);
    warnings = List.copyOf(warnings);
  }

  /**
   * Whether and how the clock goes back.
   *
   * @return a few words for users
   */
  public String clockInWords() {
    if (timestampsMonotonic) {
      return "never goes back";
    }
    return segments.size() > 1
        ? "goes back: " + segments.size() + " segments"
        : "goes back by 1 ms or less";
  }

  /**
   * Reads a recording from its start to its end, in bounded memory.
   *
   * @param reader at its start; at its end afterwards
   * @param progress receives the progress
   * @param also receive the whole stream; must not change packets
   * @return the summary
   * @throws InterruptedIOException if the thread is interrupted
   * @throws IOException if the file can no longer be read
   */
  public static RecordingSummary scan(
      RecordingReader reader, ProgressListener progress, StreamHandler... also) throws IOException {
    Scan scan = new Scan(List.of(also));
    long reported = 0;
    while (reader.next(scan)) {
      if (Thread.currentThread().isInterrupted()) {
        throw new InterruptedIOException("interrupted while reading " + reader.path());
      }
      if (reader.positionBytes() > reported) {
        reported = reader.positionBytes();
        progress.progress(reported, reader.sizeBytes());
      }
    }
    boolean others = reader.violations().count(Violation.OTHER_DATA) > 0;
    return scan.summary(reader, others ? reader.countSamples() : scan.handed);
  }

  private static final class Scan implements StreamHandler {
    private final List<Gap> gaps = new ArrayList<>();
    private final List<TimeSegment> segments = new ArrayList<>();
    private long gapCount;
    private long segmentCount;
    private long events;
    private long on;
    private long firstUs;
    private long segmentFirstUs;
    private long lastUs;
    private boolean inSegment;
    private long durationUs;
    private long peakStartUs;
    private long peakEvents;
    private long peak;
    private boolean monotonic = true;
    private boolean lossReported;
    private final List<StreamHandler> also;
    private SampleCounts handed = SampleCounts.NONE;

    Scan(List<StreamHandler> also) {
      this.also = also;
    }

    @Override
    public void sample(SensorSample sample) {
      handed = handed.plus(sample.kind());
      also.forEach(handler -> handler.sample(sample));
    }

    @Override
    public void packet(EventPacket packet) {
      also.forEach(handler -> handler.packet(packet));
      int size = packet.size();
      if (size == 0) {
        return;
      }
      if (!inSegment) {
        inSegment = true;
        segmentFirstUs = packet.firstTimeUs();
        firstUs = events == 0 ? segmentFirstUs : firstUs;
        lastUs = segmentFirstUs;
        startPeak(segmentFirstUs);
      }
      for (int i = 0; i < size; i++) {
        long timeUs = packet.timeUs(i);
        if (timeUs - lastUs >= SILENCE_US && !lossReported) {
          addGap(new Gap(lastUs, timeUs, false));
        }
        lossReported = false;
        lastUs = timeUs;
        if (timeUs - peakStartUs >= PEAK_US) {
          long elapsedUs = timeUs - peakStartUs;
          startPeak(peakStartUs + elapsedUs - elapsedUs % PEAK_US);
        }
        peakEvents++;
        on += packet.isOn(i) ? 1 : 0;
      }
      events += size;
    }

    private void startPeak(long timeUs) {
      peak = Math.max(peak, peakEvents);
      peakEvents = 0;
      peakStartUs = timeUs;
    }

    private void addGap(Gap gap) {
      gapCount++;
      if (gaps.size() < MAX_LISTED) {
        gaps.add(gap);
      }
    }

    private void endSegment() {
      if (inSegment) {
        inSegment = false;
        durationUs += lastUs - segmentFirstUs;
        segmentCount++;
        if (segments.size() < MAX_LISTED) {
          segments.add(new TimeSegment(segmentFirstUs, lastUs));
        }
      }
    }

    @Override
    public void notified(StreamNotification notification) {
      also.forEach(handler -> handler.notified(notification));
      if (notification instanceof DataLost lost) {
        addGap(new Gap(lost.fromUs(), lost.toUs(), true));
        lossReported = true;
      } else if (notification instanceof Reset) {
        monotonic = false;
        endSegment();
      }
    }

    RecordingSummary summary(RecordingReader reader, SampleCounts samples) {
      startPeak(0);
      endSegment();
      List<String> warnings = new ArrayList<>(reader.remarks());
      warnings.addAll(
          reader
              .violations()
              .describe(samples.isEmpty() ? Set.of() : Set.of(Violation.OTHER_DATA)));
      if (gapCount > MAX_LISTED) {
        warnings.add(gapCount + " gaps, of which the first " + MAX_LISTED + " are listed");
      }
      if (segmentCount > MAX_LISTED) {
        warnings.add(segmentCount + " segments, of which the first " + MAX_LISTED + " are listed");
      }
      double durationS = durationUs / 1e6;
      return new RecordingSummary(
          reader.formatName(),
          reader.geometry(),
          events,
          on,
          events - on,
          events == 0 ? 0 : firstUs,
          events == 0 ? 0 : lastUs,
          durationS,
          durationUs == 0 ? 0 : events / durationS,
          peak * (1e6 / PEAK_US),
          monotonic && reader.violations().count(Violation.OUT_OF_ORDER) == 0,
          gaps,
          segments,
          samples,
          warnings);
    }
  }
}
