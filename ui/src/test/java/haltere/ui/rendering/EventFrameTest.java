package haltere.ui.rendering;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.DataLost;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class EventFrameTest {
  private final SensorGeometry geometry = new SensorGeometry(4, 3);
  private final EventFrame frame = new EventFrame(geometry);

  @Test
  void frameStoresTimeAndPolarityOfTheLastEvent() {
    EventPacket packet = new EventPacket(3);
    packet.append(-5, 1, 2, true);
    packet.append(10, 1, 2, false);
    packet.append(20, 3, 0, true);
    frame.packet(packet);
    assertEquals(10, frame.lastUs(1, 2));
    assertFalse(frame.lastOn(1, 2));
    assertEquals(20, frame.lastUs(3, 0));
    assertTrue(frame.lastOn(3, 0));
    assertEquals(StreamNotification.NO_TIME_US, frame.lastUs(0, 0));
    assertFalse(frame.lastOn(0, 0));
    assertEquals(20, frame.nowUs());
  }

  @Test
  void negativeTimesKeepTheirPolarity() {
    frame.packet(one(-7, 2, 1, true));
    assertEquals(-7, frame.lastUs(2, 1));
    assertTrue(frame.lastOn(2, 1));
  }

  @Test
  void eventsOutsideTheSensorAreIgnored() {
    EventPacket packet = new EventPacket(2);
    packet.append(1, EventAddress.pack(4, 0, true));
    packet.append(2, EventAddress.pack(0, 3, true));
    frame.packet(packet);
    for (int y = 0; y < 3; y++) {
      for (int x = 0; x < 4; x++) {
        assertEquals(StreamNotification.NO_TIME_US, frame.lastUs(x, y));
      }
    }
  }

  @ParameterizedTest
  @EnumSource(Reset.Cause.class)
  void everyResetClearsTheFrame(Reset.Cause cause) {
    frame.packet(one(1000, 1, 1, true));
    frame.notified(new Reset(cause));
    assertEquals(StreamNotification.NO_TIME_US, frame.lastUs(1, 1));
    assertEquals(StreamNotification.NO_TIME_US, frame.nowUs());
    frame.packet(one(3, 2, 2, false));
    assertEquals(3, frame.nowUs());
  }

  @Test
  void streamStartClearsTheFrameAndDataLossDoesNot() {
    frame.packet(one(1000, 1, 1, true));
    frame.notified(new DataLost(1, 1, 1000, 2000, "test"));
    assertEquals(1000, frame.lastUs(1, 1));
    frame.notified(new StreamStarted(geometry, "other"));
    assertEquals(StreamNotification.NO_TIME_US, frame.lastUs(1, 1));
  }

  @Test
  void timeAdvancesWithoutEventsAndNeverDecreases() {
    frame.packet(one(1000, 1, 1, true));
    frame.advanceTo(3000);
    frame.advanceTo(2000);
    assertEquals(3000, frame.nowUs());
  }

  @Test
  void lastMinutesAreStoredEvenAfterHours() {
    long hourUs = 3_600_000_000L;
    for (long timeUs = -hourUs; timeUs <= hourUs; timeUs += 50_000_000) {
      frame.packet(one(timeUs, 1, 1, true));
      frame.packet(one(timeUs + 1_000_000, 2, 1, false));
      assertEquals(timeUs, frame.lastUs(1, 1));
      assertTrue(frame.lastOn(1, 1));
      assertEquals(timeUs + 1_000_000, frame.lastUs(2, 1));
      assertFalse(frame.lastOn(2, 1));
    }
    frame.packet(one(2 * hourUs, 3, 1, true));
    assertEquals(StreamNotification.NO_TIME_US, frame.lastUs(1, 1));
  }

  @Test
  void onePacketMaySpanHours() {
    EventPacket packet = new EventPacket(2);
    packet.append(5, 1, 1, true);
    packet.append(7_200_000_000L, 2, 1, false);
    frame.packet(packet);
    assertEquals(7_200_000_000L, frame.lastUs(2, 1));
    assertEquals(StreamNotification.NO_TIME_US, frame.lastUs(1, 1));
  }

  static EventPacket one(long timeUs, int x, int y, boolean on) {
    EventPacket packet = new EventPacket(1);
    packet.append(timeUs, x, y, on);
    return packet;
  }
}
