package haltere.core.playback.internal;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.event.SensorSample;
import haltere.core.playback.PlaybackClock;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.EventSource;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.util.Objects;

/**
 * Paces the stream of another source like a camera: events come at their time, in packets of at
 * most some milliseconds, from the first event on. A slow consumer receives them later; nothing is
 * lost.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class PacedSource implements EventSource {
  private static final long PIECE_US = 2000;

  private final EventSource source;
  private final PlaybackClock clock;
  private final EventPacket pending = new EventPacket(4096);
  private final EventPacket piece = new EventPacket(4096);
  private int index;
  private boolean anchored;

  /**
   * A paced source.
   *
   * @param source of the stream; closed with this
   * @param clock with the speed
   */
  public PacedSource(EventSource source, PlaybackClock clock) {
    this.source = Objects.requireNonNull(source, "source");
    this.clock = Objects.requireNonNull(clock, "clock");
    clock.resume();
  }

  @Override
  public SensorGeometry geometry() {
    return source.geometry();
  }

  @Override
  public boolean next(StreamHandler handler) throws IOException {
    if (index == pending.size()) {
      return source.next(new Forwarder(handler))
          && (index == pending.size() || deliverDue(handler));
    }
    return deliverDue(handler);
  }

  /** Waits for the next events and passes them on. */
  private boolean deliverDue(StreamHandler handler) throws InterruptedIOException {
    int end = Math.max(index + 1, pending.indexAtOrAfter(pending.timeUs(index) + PIECE_US, index));
    await(pending.timeUs(end - 1));
    piece.clear();
    piece.append(pending, index, end);
    index = end;
    handler.packet(piece);
    return true;
  }

  private void await(long timeUs) throws InterruptedIOException {
    if (!anchored) {
      clock.setPosition(timeUs);
      anchored = true;
    }
    try {
      for (long nanos = clock.nanosUntil(timeUs); nanos > 0; nanos = clock.nanosUntil(timeUs)) {
        clock.sleep(nanos);
      }
    } catch (InterruptedException interrupted) {
      Thread.currentThread().interrupt();
      throw new InterruptedIOException("interrupted while waiting for the time of an event");
    }
  }

  /** Keeps a packet until it is due; passes on samples and notifications at once. */
  private final class Forwarder implements StreamHandler {
    private final StreamHandler handler;

    Forwarder(StreamHandler handler) {
      this.handler = handler;
    }

    @Override
    public void packet(EventPacket packet) {
      if (packet.isEmpty()) {
        handler.packet(packet);
        return;
      }
      pending.clear();
      pending.append(packet, 0, packet.size());
      index = 0;
    }

    @Override
    public void sample(SensorSample sample) {
      handler.sample(sample);
    }

    @Override
    public void notified(StreamNotification notification) {
      anchored &= !notification.endsContinuity() && !(notification instanceof EndOfStream);
      handler.notified(notification);
    }
  }

  @Override
  public void close() throws IOException {
    source.close();
  }
}
