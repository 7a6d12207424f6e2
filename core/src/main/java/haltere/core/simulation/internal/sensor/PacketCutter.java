package haltere.core.simulation.internal.sensor;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.simulation.RunSettings;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;

/**
 * Cuts the events of a scene, made interval by interval, into packets between the start and the end
 * of the stream. A packet is full, or spans 10 ms. After a second of scene time without events, an
 * empty packet returns control to the caller.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class PacketCutter {
  /** Makes the events of a scene. */
  public interface Maker {
    /**
     * Makes those of the next interval.
     *
     * @param out gets them behind those it has, in order of time
     * @return the end of the interval, microseconds since the beginning
     */
    long make(EventPacket out);
  }

  private static final long SPAN_US = 10_000;
  private static final long SILENCE_US = 1_000_000;

  private enum CutterState {
    BEFORE,
    RUNNING,
    ENDED
  }

  private final RunSettings run;
  private final SensorGeometry geometry;
  private final String source;
  private final int maxEvents;
  private final Maker maker;
  private final EventPacket made = new EventPacket(8192);
  private final EventPacket packet;
  private CutterState state = CutterState.BEFORE;
  private int handedOut;
  private long madeUntilUs;
  private long lastUs = StreamNotification.NO_TIME_US;

  /**
   * A stream at its start.
   *
   * @param run start and length
   * @param geometry the sensor
   * @param source name in the start of the stream
   * @param maxEvents of a packet, above 0
   * @param maker makes the events
   */
  public PacketCutter(
      RunSettings run, SensorGeometry geometry, String source, int maxEvents, Maker maker) {
    this.run = run;
    this.geometry = geometry;
    this.source = source;
    this.maxEvents = maxEvents;
    this.maker = maker;
    packet = new EventPacket(maxEvents);
  }

  /**
   * Passes on the next packet, or the start or the end.
   *
   * @param handler receives it
   * @return false after the end
   */
  public boolean next(StreamHandler handler) {
    switch (state) {
      case BEFORE -> {
        state = CutterState.RUNNING;
        handler.notified(new StreamStarted(geometry, source));
        return true;
      }
      case RUNNING -> {
        fill();
        if (packet.isEmpty() && isAllMade()) {
          state = CutterState.ENDED;
          handler.notified(new EndOfStream(lastUs));
        } else {
          lastUs = packet.isEmpty() ? lastUs : packet.lastTimeUs();
          handler.packet(packet);
        }
        return true;
      }
      default -> {
        return false;
      }
    }
  }

  private boolean isAllMade() {
    return handedOut == made.size()
        && run.durationUs().isPresent()
        && madeUntilUs >= run.durationUs().getAsLong();
  }

  private void fill() {
    packet.clear();
    long fromUs = madeUntilUs;
    while (packet.size() < maxEvents) {
      if (handedOut == made.size()) {
        long limitUs = packet.isEmpty() ? SILENCE_US : SPAN_US;
        if (isAllMade() || madeUntilUs - fromUs >= limitUs) {
          return;
        }
        made.clear();
        handedOut = 0;
        madeUntilUs = maker.make(made);
      }
      int count = Math.min(maxEvents - packet.size(), made.size() - handedOut);
      packet.append(made, handedOut, handedOut + count);
      handedOut += count;
    }
  }
}
