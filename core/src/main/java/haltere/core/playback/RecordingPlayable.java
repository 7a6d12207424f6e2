package haltere.core.playback;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.event.SensorSample;
import haltere.core.format.RecordingReader;
import haltere.core.format.TimeSegment;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.io.IOException;
import java.util.List;
import java.util.Objects;
import java.util.OptionalLong;

/**
 * A recording as a playable: its segments are laid end to end, each from its first event to 1 us
 * after its last. A recording without events is as long as its samples, if its reader gives them.
 *
 * <p>Thread rule: as {@link Playable}.
 *
 * @since 0.1
 */
public final class RecordingPlayable implements Playable {
  private final RecordingReader reader;
  private final List<TimeSegment> segments;
  private final long[] startsUs;
  private final long durationUs;
  private final boolean hasEvents;
  private int current;

  /**
   * Takes a reader over and asks it for its segments, which may read through the file: not for a
   * thread that someone waits for.
   *
   * @param reader owned and closed from now on, unless this throws
   * @throws IOException if the file cannot be read
   */
  public RecordingPlayable(RecordingReader reader) throws IOException {
    this.reader = Objects.requireNonNull(reader, "reader");
    segments = List.copyOf(reader.segments());
    startsUs = new long[segments.size()];
    long start = 0;
    for (int i = 0; i < startsUs.length; i++) {
      startsUs[i] = start;
      start += segments.get(i).durationUs() + 1;
    }
    durationUs = start;
    hasEvents = reader.hasEvents();
  }

  /**
   * The recording.
   *
   * @return the reader, for properties of the file
   */
  public RecordingReader reader() {
    return reader;
  }

  @Override
  public String name() {
    return String.valueOf(reader.path().getFileName());
  }

  @Override
  public SensorGeometry geometry() {
    return reader.geometry();
  }

  @Override
  public OptionalLong durationUs() {
    return OptionalLong.of(durationUs);
  }

  @Override
  public boolean hasEvents() {
    return hasEvents;
  }

  @Override
  public boolean seekable() {
    return true;
  }

  @Override
  public void seek(long elapsedUs) throws IOException {
    if (segments.isEmpty()) {
      reader.seek(StreamNotification.NO_TIME_US);
      return;
    }
    int segment = 0;
    while (segment < startsUs.length - 1 && startsUs[segment + 1] <= elapsedUs) {
      segment++;
    }
    long inSegmentUs = Math.max(0, elapsedUs - startsUs[segment]);
    reader.seek(segment, segments.get(segment).firstUs() + inSegmentUs);
    current = segment;
  }

  @Override
  public boolean next(StreamHandler handler) throws IOException {
    return reader.next(
        new StreamHandler() {
          @Override
          public void packet(EventPacket packet) {
            handler.packet(packet);
          }

          @Override
          public void sample(SensorSample sample) {
            handler.sample(sample);
          }

          @Override
          public void notified(StreamNotification notification) {
            if (notification instanceof Reset reset
                && reset.cause() == Reset.Cause.CLOCK_RESTARTED
                && current < startsUs.length - 1) {
              current++;
            }
            handler.notified(notification);
          }
        });
  }

  @Override
  public long elapsedUs(long timeUs) {
    return segments.isEmpty() ? 0 : startsUs[current] + timeUs - segments.get(current).firstUs();
  }

  @Override
  public void close() throws IOException {
    reader.close();
  }
}
