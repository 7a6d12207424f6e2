package haltere.testing;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.event.SensorSample;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.CRC32;

/**
 * Keeps a copy of everything that a stream brings: its events one after the other, and its
 * notifications each with the number of events before it.
 */
public final class StreamRecorder implements StreamHandler {
  private final EventPacket events = new EventPacket(0);
  private final List<Notice> notifications = new ArrayList<>();
  private final List<Read> samples = new ArrayList<>();
  private int largestPacket;

  /** A recorder of nothing yet. */
  public StreamRecorder() {}

  /**
   * A notification and its position.
   *
   * @param eventsBefore events that came before it
   * @param notification the notification
   */
  public record Notice(int eventsBefore, StreamNotification notification) {}

  /**
   * A sample and its position.
   *
   * @param eventsBefore events that came before it
   * @param sample the sample
   */
  public record Read(int eventsBefore, SensorSample sample) {}

  @Override
  public void packet(EventPacket packet) {
    events.append(packet, 0, packet.size());
    largestPacket = Math.max(largestPacket, packet.size());
  }

  @Override
  public void sample(SensorSample sample) {
    samples.add(new Read(events.size(), sample));
  }

  @Override
  public void notified(StreamNotification notification) {
    notifications.add(new Notice(events.size(), notification));
  }

  /**
   * All events in the order in which they came, whatever their times.
   *
   * @return not copied
   */
  public EventPacket events() {
    return events;
  }

  /**
   * All notifications in the order in which they came.
   *
   * @return not copied
   */
  public List<Notice> notifications() {
    return notifications;
  }

  /**
   * All samples, each with its place.
   *
   * @return not copied
   */
  public List<Read> placedSamples() {
    return samples;
  }

  /**
   * The samples of a kind.
   *
   * @param kind class of the sample
   * @param <T> the kind
   * @return in the order in which they came
   */
  public <T extends SensorSample> List<T> samples(Class<T> kind) {
    return samples.stream().map(Read::sample).filter(kind::isInstance).map(kind::cast).toList();
  }

  /**
   * The notifications of a kind.
   *
   * @param kind class of the notification
   * @param <T> the kind
   * @return in the order in which they came
   */
  public <T extends StreamNotification> List<T> notifications(Class<T> kind) {
    return notifications.stream()
        .map(Notice::notification)
        .filter(kind::isInstance)
        .map(kind::cast)
        .toList();
  }

  /**
   * The most events that came at a time.
   *
   * @return at least 0
   */
  public int largestPacket() {
    return largestPacket;
  }

  /**
   * Digest of all events: CRC-32 of rows of four little-endian 64-bit numbers, time, x, y and 1 for
   * ON.
   *
   * @return eight hexadecimal digits
   */
  public String crc32() {
    return crc32(new SensorGeometry(1, 1, Origin.BOTTOM));
  }

  /**
   * Digest of all events in the coordinates of their source, whose rows may count from the top.
   *
   * @param sensor where the events come from
   * @return eight hexadecimal digits, see {@link #crc32()}
   */
  public String crc32(SensorGeometry sensor) {
    int top = sensor.height() - 1;
    boolean fromTop = sensor.origin() == Origin.TOP;
    CRC32 crc = new CRC32();
    java.nio.ByteBuffer row =
        java.nio.ByteBuffer.allocate(32).order(java.nio.ByteOrder.LITTLE_ENDIAN);
    for (int i = 0; i < events.size(); i++) {
      row.clear();
      int y = events.y(i);
      row.putLong(events.timeUs(i)).putLong(events.x(i)).putLong(fromTop ? top - y : y);
      row.putLong(events.isOn(i) ? 1 : 0);
      crc.update(row.array());
    }
    return String.format("%08x", crc.getValue());
  }
}
