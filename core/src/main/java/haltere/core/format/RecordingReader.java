package haltere.core.format;

import haltere.core.format.summary.RecordingSummary;
import haltere.core.stream.EventSource;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A recording as a source of events. It streams: memory is bounded whatever the file's size or what
 * its headers claim.
 *
 * <p>A jump back of the recording's clock that is no wrap becomes a {@code Reset(CLOCK_RESTARTED)};
 * the stretches between such jumps are the recording's segments.
 *
 * <p>Thread rule: one thread at a time.
 *
 * @since 0.1
 */
public interface RecordingReader extends EventSource {
  /**
   * The format's name.
   *
   * @return as {@link RecordingFormat#name()}, with the version where there are several
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
   * What was wrong or left out so far.
   *
   * @return live counts
   */
  ViolationCounts violations();

  /**
   * What a user should know about how the file was read, such as a sensor size that was assumed.
   *
   * @return one line each
   */
  List<String> remarks();

  /**
   * What its times count from, and whether the clock in the file is a narrow one.
   *
   * @return facts of the format, or of the kind of events that are read
   */
  RecordingClock clock();

  /**
   * Number and times of the events as stated by the file, if it is consistent. Does not move this
   * reader.
   *
   * @return empty if only reading shows them; see {@link RecordingSummary}
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
   * @return name of the method, such as "lz4", or "none"; empty where the format does not say
   */
  default Optional<String> compression() {
    return Optional.empty();
  }

  /**
   * How many frames, inertial samples and triggers the recording holds, whether or not they are
   * wanted as a part of the stream. It may read through the file, but does not move this reader.
   *
   * @return counts; {@link SampleCounts#NONE} for formats without samples
   * @throws IOException if the file can no longer be read
   */
  default SampleCounts countSamples() throws IOException {
    return SampleCounts.NONE;
  }

  /**
   * Whether one can go back and forth in the recording.
   *
   * @return false for a stream, which only {@link #next} reads
   */
  default boolean isSeekable() {
    return true;
  }

  /**
   * The stretches of continuous time, in file order. The first call may read through the file.
   *
   * @return at least one segment unless the recording has no event; where samples are read and
   *     there is no event, the segment from the first to the last sample
   * @throws IOException if the file can no longer be read
   */
  List<TimeSegment> segments() throws IOException;

  /**
   * Goes on at the first event at or after a time within a segment; behind the segment's end that
   * is the start of the next. What is handed over next is a {@code Reset(SEEK)} (before the first
   * call of {@link #next} it is the start of the stream). May be called after the end of the
   * stream, which then restarts.
   *
   * @param segment index into {@link #segments()}
   * @param timeUs time on the recording's clock
   * @throws IOException if the file can no longer be read
   */
  void seek(int segment, long timeUs) throws IOException;

  /**
   * Goes on at the first event at or after a time, in the first segment that reaches that far.
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
