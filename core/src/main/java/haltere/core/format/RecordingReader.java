package haltere.core.format;

import haltere.core.format.summary.RecordingSummary;
import haltere.core.stream.EventSource;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A recording as a source of events. It streams: memory is bounded for files of any size and with
 * any header.
 *
 * <p>A backward jump of the recording's clock other than a wrap becomes a {@code
 * Reset(CLOCK_RESTARTED)}; the sections between such jumps are the recording's segments. A step
 * back by 1 ms or less is disorder instead: late events get the time of the newest one before them,
 * and a {@link Violation#OUT_OF_ORDER} is counted.
 *
 * <p>Thread rule: one thread at a time.
 *
 * @since 0.1
 */
public interface RecordingReader extends EventSource {
  /**
   * The format's name.
   *
   * @return as {@link RecordingFormat#name()}, with the version if there are several
   */
  String formatName();

  /**
   * The file.
   *
   * @return its path
   */
  Path path();

  /**
   * Bytes of the file decoded so far, for a progress bar.
   *
   * @return 0 to {@link #sizeBytes()}
   */
  long positionBytes();

  /**
   * Size of the file.
   *
   * @return bytes
   */
  long sizeBytes();

  /**
   * Violations of the format so far.
   *
   * @return live counts
   */
  ViolationCounts violations();

  /**
   * Remarks for users about the reading of the file, such as an assumed sensor size.
   *
   * @return one line each
   */
  List<String> remarks();

  /**
   * Origin of its times, and wrap period of the clock in the file.
   *
   * @return the clock of the format, or of the kind of events that are read
   */
  RecordingClock clock();

  /**
   * Number and times of the events as stated by the file, if it is consistent. Does not move this
   * reader.
   *
   * @return empty if the events must be read for it; see {@link RecordingSummary}
   * @throws IOException if the file can no longer be read
   */
  default Optional<RecordingOutline> outline() throws IOException {
    return Optional.empty();
  }

  /**
   * Metadata of the recording: camera, its settings and the chain of filters.
   *
   * @return as {@link WriteOptions#metadata()} when it was written; empty for formats without
   *     metadata
   */
  default Map<String, String> metadata() {
    return Map.of();
  }

  /**
   * How the events are compressed.
   *
   * @return name of the method, such as "lz4", or "none"; empty if the format does not state it
   */
  default Optional<String> compression() {
    return Optional.empty();
  }

  /**
   * Numbers of frames, inertial samples and triggers of the recording, even if they are not part of
   * the stream. It may read the whole file, but does not move this reader.
   *
   * @return counts; {@link SampleCounts#NONE} for formats without samples
   * @throws IOException if the file can no longer be read
   */
  default SampleCounts countSamples() throws IOException {
    return SampleCounts.NONE;
  }

  /**
   * Whether the recording supports seeking.
   *
   * @return false for a stream
   */
  default boolean isSeekable() {
    return true;
  }

  /**
   * The sections of continuous time, in file order. The first call may read the whole file.
   *
   * @return at least one segment if the recording has an event; without events but with samples
   *     that are read, the segment from the first to the last sample
   * @throws IOException if the file can no longer be read
   */
  List<TimeSegment> segments() throws IOException;

  /**
   * Whether there are events. The first call may read the whole file.
   *
   * @return false if there are only samples, or nothing
   * @throws IOException if the file can no longer be read
   */
  default boolean hasEvents() throws IOException {
    return true;
  }

  /**
   * Continues at the first event at or after a time within a segment; after the segment's end that
   * is the start of the next. The next element is a {@code Reset(SEEK)} (before the first call of
   * {@link #next}, the start of the stream). May be called after the end of the stream, which then
   * restarts.
   *
   * @param segment index into {@link #segments()}
   * @param timeUs time on the recording's clock
   * @throws IOException if the file can no longer be read
   */
  void seek(int segment, long timeUs) throws IOException;

  /**
   * Continues at the first event at or after a time, in the first segment that ends at or after it.
   *
   * @param timeUs time on the recording's clock
   * @throws IOException if the file can no longer be read
   */
  default void seek(long timeUs) throws IOException {
    List<TimeSegment> segments = segments();
    int segment = 0;
    while (segment < segments.size() - 1 && segments.get(segment).lastUs() < timeUs) {
      segment++;
    }
    seek(segment, timeUs);
  }
}
