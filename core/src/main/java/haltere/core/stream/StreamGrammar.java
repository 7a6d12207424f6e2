package haltere.core.stream;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.event.SensorSample;
import java.util.Objects;

/**
 * Checks, in front of another handler, that the stream follows the grammar of {@link
 * StreamNotification}, that times do not descend and that pixels lie on the sensor.
 *
 * @since 0.1
 */
public final class StreamGrammar implements StreamHandler {
  private enum GrammarState {
    BEFORE_START,
    RUNNING,
    DEVICE_LOST,
    ENDED
  }

  private final StreamHandler next;
  private GrammarState state = GrammarState.BEFORE_START;
  private SensorGeometry geometry;
  private long lastUs = Long.MIN_VALUE;

  /**
   * Checks a stream in front of a handler.
   *
   * @param next receives the checked stream
   */
  public StreamGrammar(StreamHandler next) {
    this.next = Objects.requireNonNull(next, "next");
  }

  /**
   * Whether the stream has come to its end.
   *
   * @return true after {@link EndOfStream}
   */
  public boolean ended() {
    return state == GrammarState.ENDED;
  }

  @Override
  public void packet(EventPacket packet) {
    require(state == GrammarState.RUNNING, "a packet came " + where());
    for (int i = 0; i < packet.size(); i++) {
      long timeUs = packet.timeUs(i);
      if (timeUs < lastUs) {
        throw new IllegalStateException(
            "time went back from " + lastUs + " us to " + timeUs + " us without a notification");
      }
      lastUs = timeUs;
      if (!geometry.contains(packet.x(i), packet.y(i))) {
        throw new IllegalStateException(
            "pixel (" + packet.x(i) + ", " + packet.y(i) + ") is outside of " + geometry);
      }
    }
    next.packet(packet);
  }

  /** {@inheritDoc} Its time is not checked: sources order samples as near as they can. */
  @Override
  public void sample(SensorSample sample) {
    require(state == GrammarState.RUNNING, "a sample came " + where());
    next.sample(sample);
  }

  @Override
  public void notified(StreamNotification notification) {
    if (notification instanceof StreamStarted started) {
      require(
          state == GrammarState.BEFORE_START || state == GrammarState.ENDED,
          "the stream started " + where());
      geometry = started.geometry();
      state = GrammarState.RUNNING;
    } else if (notification instanceof EndOfStream) {
      require(
          state == GrammarState.RUNNING || state == GrammarState.DEVICE_LOST,
          "the end of stream came " + where());
      state = GrammarState.ENDED;
    } else {
      require(state == GrammarState.RUNNING, notification + " came " + where());
      if (notification instanceof DeviceLost) {
        state = GrammarState.DEVICE_LOST;
      }
    }
    if (notification.endsContinuity()) {
      lastUs = Long.MIN_VALUE;
    }
    next.notified(notification);
  }

  private String where() {
    return switch (state) {
      case BEFORE_START -> "before the start of the stream";
      case RUNNING -> "while the stream was running";
      case DEVICE_LOST -> "after the device was lost";
      case ENDED -> "after the end of the stream";
    };
  }

  private static void require(boolean condition, String message) {
    if (!condition) {
      throw new IllegalStateException(message);
    }
  }
}
