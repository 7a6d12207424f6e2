package haltere.core.sink;

import haltere.core.event.EventPacket;
import haltere.core.format.RecordingWriter;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.io.Closeable;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Objects;
import java.util.Optional;

/**
 * Writes a stream to a recording. When playback jumps, the recording is at its end: what comes
 * after a {@code Reset(REWIND)} or {@code Reset(SEEK)} that follows events is not written but
 * counted.
 *
 * <p>Thread rule: one thread at a time; it writes on the thread that hands it packets.
 */
public final class RecordingSink implements StreamHandler, Closeable {
  private final RecordingWriter writer;
  private Reset stoppedBy;
  private long events;
  private long eventsAfterStop;

  /**
   * A sink at the start of a recording.
   *
   * @param writer owned and closed from now on
   */
  public RecordingSink(RecordingWriter writer) {
    this.writer = Objects.requireNonNull(writer, "writer");
  }

  /**
   * Writes a packet.
   *
   * @param packet borrowed and not changed
   * @throws UncheckedIOException if it cannot be written
   */
  @Override
  public void packet(EventPacket packet) {
    if (stoppedBy != null) {
      eventsAfterStop += packet.size();
      return;
    }
    try {
      writer.write(packet);
      events += packet.size();
    } catch (IOException thrown) {
      throw new UncheckedIOException(thrown);
    }
  }

  @Override
  public void notified(StreamNotification notification) {
    if (stoppedBy == null
        && events > 0
        && notification instanceof Reset reset
        && (reset.cause() == Reset.Cause.REWIND || reset.cause() == Reset.Cause.SEEK)) {
      stoppedBy = reset;
    }
  }

  /**
   * Events written.
   *
   * @return a count
   */
  public long events() {
    return events;
  }

  /**
   * Events that came after playback had jumped.
   *
   * @return a count
   */
  public long eventsAfterStop() {
    return eventsAfterStop;
  }

  /**
   * The jump that ended the recording.
   *
   * @return the first one, or empty
   */
  public Optional<Reset> stoppedBy() {
    return Optional.ofNullable(stoppedBy);
  }

  /**
   * Completes the file and puts it in its place.
   *
   * @throws IOException if that fails; the target is then as it was
   */
  public void finish() throws IOException {
    writer.finish();
  }

  /**
   * Releases the file; one that was not finished leaves nothing.
   *
   * @throws IOException if it cannot be removed
   */
  @Override
  public void close() throws IOException {
    writer.close();
  }
}
