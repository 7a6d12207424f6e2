package haltere.filters.noise;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.EventFilter;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.testing.EventFilterContract;
import haltere.testing.EventPackets;
import haltere.testing.Recorded;
import java.io.IOException;
import org.junit.jupiter.api.Test;

class BackgroundActivityFilterTest extends EventFilterContract {
  private static final SensorGeometry SENSOR = new SensorGeometry(32, 20);

  @Override
  protected EventFilter create(SensorGeometry geometry) {
    return new BackgroundActivityFilter(geometry, BackgroundActivitySettings.defaults());
  }

  @Test
  void eventPassesOnlyWithASupportingNeighbour() {
    EventPacket packet = new EventPacket(0);
    packet.append(0, 10, 10, true);
    packet.append(10, 20, 10, true);
    packet.append(20, 11, 11, false);
    EventPacket result = filtered(packet, 1000, 1, false);
    assertEquals(1, result.size());
    assertEquals(20, result.firstTimeUs());
  }

  @Test
  void supportLastsExactlyForTheCorrelationTime() {
    EventPacket packet = new EventPacket(0);
    packet.append(0, 10, 10, true);
    packet.append(1000, 10, 11, true);
    packet.append(2001, 10, 12, true);
    assertEquals(1, filtered(packet, 1000, 1, false).size());
  }

  @Test
  void pixelDoesNotSupportItself() {
    EventPacket packet = new EventPacket(0);
    for (int i = 0; i < 50; i++) {
      packet.append(i, 10, 10, true);
    }
    assertTrue(filtered(packet, 1000, 1, false).isEmpty());
  }

  @Test
  void pixelsAtOppositeEndsOfRowsAreNoNeighbours() {
    EventPacket packet = new EventPacket(0);
    packet.append(0, SENSOR.width() - 1, 4, true);
    packet.append(1, 0, 5, true);
    packet.append(2, SENSOR.width() - 1, 6, true);
    packet.append(3, 0, 0, true);
    packet.append(4, SENSOR.width() - 1, SENSOR.height() - 1, true);
    assertTrue(filtered(packet, 1000, 1, false).isEmpty());
  }

  @Test
  void neighbourOfTheOtherPolarityIsNoSupportOnRequest() {
    EventPacket packet = new EventPacket(0);
    packet.append(0, 10, 10, true);
    packet.append(1, 11, 10, false);
    packet.append(2, 12, 10, false);
    assertEquals(2, filtered(packet, 1000, 1, false).size());
    assertEquals(1, filtered(packet, 1000, 1, true).size());
  }

  @Test
  void filterMatchesTheReferenceForEveryNumberOfNeighbours() {
    for (int neighbours = 1; neighbours <= 8; neighbours++) {
      for (boolean samePolarity : new boolean[] {false, true}) {
        EventPacket random = EventPackets.uniform(SENSOR, neighbours, 20_000, -5_000, 3);
        EventPacket bars = EventPackets.movingBars(SENSOR, neighbours, 300_000, 0);
        for (EventPacket stream : new EventPacket[] {random, bars}) {
          assertEquals(
              reference(stream, 1500, neighbours, samePolarity),
              filtered(stream, 1500, neighbours, samePolarity));
        }
      }
    }
  }

  @Test
  void filterMatchesTheReferenceOverHoursAndGaps() {
    SensorGeometry tiny = new SensorGeometry(3, 3);
    BackgroundActivity filter =
        new BackgroundActivity(tiny, new BackgroundActivitySettings(10_000_000, 2, false));
    EventPacket stream = new EventPacket(0);
    long startUs = -4_000_000_000L;
    for (int part = 0; part < 12; part++) {
      EventPacket events = EventPackets.uniform(tiny, part, 800, startUs, 4_000_000);
      stream.append(events, 0, events.size());
      startUs = stream.lastTimeUs() + (1L << (20 + part)) - 5;
    }
    EventPacket expected = reference(tiny, stream, 10_000_000, 2, false);
    filter.filter(stream);
    assertEquals(expected, stream);
    assertTrue(stream.size() > 1000, "there is something to compare");
  }

  @Test
  void filterMatchesTheReferenceOnARecording() throws IOException {
    EventPacket stream = new EventPacket(0);
    SensorGeometry geometry;
    try (RecordingReader reader = Recordings.open(Recorded.file("dvs128-pendulum.aedat"))) {
      geometry = reader.geometry();
      reader.drainTo(
          new StreamHandler() {
            @Override
            public void packet(EventPacket packet) {
              stream.append(packet, 0, packet.size());
            }

            @Override
            public void notified(StreamNotification notification) {
              // This recording has no break in it.
            }
          });
    }
    for (int neighbours = 1; neighbours <= 3; neighbours++) {
      EventPacket packet = EventPackets.copy(stream);
      new BackgroundActivity(geometry, new BackgroundActivitySettings(5000, neighbours, true))
          .filter(packet);
      assertEquals(reference(geometry, stream, 5000, neighbours, true), packet);
      assertTrue(packet.size() > 50_000, "events left: " + packet.size());
    }
  }

  /** One look at all nine pixels of a plain map of 64-bit times, with bounds checked by hand. */
  private static EventPacket reference(
      SensorGeometry geometry,
      EventPacket stream,
      long correlationUs,
      int neighbours,
      boolean samePolarity) {
    Long[][][] last = new Long[2][geometry.width()][geometry.height()];
    EventPacket passed = new EventPacket(0);
    for (int i = 0; i < stream.size(); i++) {
      int map = samePolarity && stream.isOn(i) ? 1 : 0;
      int support = 0;
      for (int x = stream.x(i) - 1; x <= stream.x(i) + 1; x++) {
        for (int y = stream.y(i) - 1; y <= stream.y(i) + 1; y++) {
          boolean self = x == stream.x(i) && y == stream.y(i);
          if (!self
              && geometry.contains(x, y)
              && last[map][x][y] != null
              && stream.timeUs(i) - last[map][x][y] <= correlationUs) {
            support++;
          }
        }
      }
      if (support >= neighbours) {
        passed.append(stream.timeUs(i), stream.x(i), stream.y(i), stream.isOn(i));
      }
      last[map][stream.x(i)][stream.y(i)] = stream.timeUs(i);
    }
    return passed;
  }

  private static EventPacket reference(
      EventPacket stream, long correlationUs, int neighbours, boolean samePolarity) {
    return reference(SENSOR, stream, correlationUs, neighbours, samePolarity);
  }

  private static EventPacket filtered(
      EventPacket stream, int correlationUs, int neighbours, boolean samePolarity) {
    EventPacket packet = EventPackets.copy(stream);
    new BackgroundActivity(
            SENSOR, new BackgroundActivitySettings(correlationUs, neighbours, samePolarity))
        .filter(packet);
    return packet;
  }
}
