package haltere.ui.rendering;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.util.Arrays;

/**
 * The last event of each pixel: time and polarity. A {@link FramePainter} turns it into colours
 * that fade with age. Only the last minutes are stored.
 *
 * <p>After a start of the stream, a rewind, a seek or any other reset nothing of the time before is
 * left. Lost data leaves the picture as it is, because time goes on.
 *
 * <p>Thread rule: one thread at a time, in the viewer the processing thread.
 */
public final class EventFrame implements StreamHandler {
  /** Entry of a pixel that has had no event; far older than any event can be. */
  private static final int NEVER = -(1 << 30);

  /** Longest time from the epoch to an event, 268 s. At least half of it is remembered. */
  private static final long MAX_AGE_US = 1L << 28;

  /** Latest time after the epoch from which ages can count. */
  private static final long LATEST_US = (1L << 29) - 1;

  private final SensorGeometry geometry;

  /**
   * For each pixel, row by row from the bottom: time of its last event since the epoch times two,
   * plus 1 for ON. Half as wide as an absolute time, so a picture is painted twice as fast; events
   * older than about two minutes may count as never.
   */
  private final int[] lastEvents;

  /** Time that the entries count from, so that the first event's is 1 us. */
  private long epochUs;

  private long nowUs = StreamNotification.NO_TIME_US;
  private boolean dirty;

  /** A frame without events; events outside the sensor are ignored. */
  public EventFrame(SensorGeometry geometry) {
    this.geometry = geometry;
    this.lastEvents = new int[geometry.pixels()];
    Arrays.fill(lastEvents, NEVER);
  }

  /** The sensor. */
  public SensorGeometry geometry() {
    return geometry;
  }

  @Override
  public void packet(EventPacket packet) {
    int size = packet.size();
    if (size == 0) {
      return;
    }
    long[] times = packet.timesUs();
    int[] addresses = packet.addresses();
    int width = geometry.width();
    int height = geometry.height();
    if (!dirty) {
      epochUs = times[0] - 1;
    }
    for (int i = 0; i < size; i++) {
      if (times[i] - epochUs > MAX_AGE_US) {
        moveEpoch(times[i]);
      }
      int address = addresses[i];
      int x = EventAddress.x(address);
      int y = EventAddress.y(address);
      if (x < width && y < height) {
        lastEvents[y * width + x] =
            (int) (times[i] - epochUs) << 1 | (EventAddress.isOn(address) ? 1 : 0);
      }
    }
    dirty = true;
    nowUs = times[size - 1];
  }

  /** Makes room for later times, forgetting events that are half the longest time old. */
  private void moveEpoch(long timeUs) {
    long newEpochUs = timeUs - MAX_AGE_US / 2;
    long moved = newEpochUs - epochUs;
    for (int i = 0; i < lastEvents.length; i++) {
      lastEvents[i] =
          lastEvents[i] != NEVER && lastEvents[i] >> 1 > moved
              ? lastEvents[i] - (int) (moved << 1)
              : NEVER;
    }
    epochUs = newEpochUs;
  }

  @Override
  public void notified(StreamNotification notification) {
    if (notification.restartsTime()) {
      clear();
    }
  }

  /** Removes all events. */
  public void clear() {
    if (dirty) {
      Arrays.fill(lastEvents, NEVER);
      dirty = false;
    }
    nowUs = StreamNotification.NO_TIME_US;
  }

  /** Advances the picture's time without events; a time before {@link #nowUs()} has no effect. */
  public void advanceTo(long timeUs) {
    nowUs = Math.max(nowUs, timeUs);
  }

  /**
   * The time from which the ages of the events count, microseconds; {@link
   * StreamNotification#NO_TIME_US} before the first event.
   */
  public long nowUs() {
    return nowUs;
  }

  /**
   * Time of a pixel's last event, rows upwards, microseconds; {@link StreamNotification#NO_TIME_US}
   * if it has had none.
   */
  public long lastUs(int x, int y) {
    int entry = lastEvents[y * geometry.width() + x];
    return entry == NEVER ? StreamNotification.NO_TIME_US : epochUs + (entry >> 1);
  }

  /** Whether a pixel's last event is ON, rows upwards; false without one. */
  public boolean lastOn(int x, int y) {
    int entry = lastEvents[y * geometry.width() + x];
    return entry != NEVER && (entry & 1) != 0;
  }

  int[] lastEvents() {
    return lastEvents;
  }

  /** The time from which ages count, on the scale of the entries. */
  int now() {
    return (int) Math.max(0, Math.min(nowUs - epochUs, LATEST_US)) << 1;
  }
}
