package haltere.core.event;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class EventPacketTest {
  @Test
  void appendedEventIsReadBack() {
    EventPacket packet = new EventPacket(0);
    packet.append(Long.MIN_VALUE, 0, EventAddress.MAX_COORDINATE, false);
    packet.append(Long.MAX_VALUE, EventAddress.MAX_COORDINATE, 0, true);
    assertEquals(2, packet.size());
    assertEquals(Long.MIN_VALUE, packet.timeUs(0));
    assertEquals(0, packet.x(0));
    assertEquals(EventAddress.MAX_COORDINATE, packet.y(0));
    assertFalse(packet.isOn(0));
    assertEquals(Long.MAX_VALUE, packet.timeUs(1));
    assertEquals(EventAddress.MAX_COORDINATE, packet.x(1));
    assertEquals(0, packet.y(1));
    assertTrue(packet.isOn(1));
  }

  @Test
  void addressesHoldAllCoordinatesOrderedByRowAndColumn() {
    SplittableRandom random = new SplittableRandom(1);
    for (int i = 0; i < 10_000; i++) {
      int x = random.nextInt(EventAddress.MAX_COORDINATE + 1);
      int y = random.nextInt(EventAddress.MAX_COORDINATE + 1);
      boolean on = random.nextBoolean();
      int address = EventAddress.pack(x, y, on);
      assertEquals(x, EventAddress.x(address));
      assertEquals(y, EventAddress.y(address));
      assertEquals(on, EventAddress.isOn(address));
      assertEquals(address, EventAddress.pack(x, y, on ? 1 : 0));
      assertTrue(address >= 0);
    }
    assertTrue(EventAddress.pack(5, 1, false) > EventAddress.pack(6, 0, true));
    assertTrue(EventAddress.pack(6, 1, false) > EventAddress.pack(5, 1, true));
  }

  @Test
  void packetGrowsAndKeepsItsEvents() {
    EventPacket packet = new EventPacket(0);
    for (int i = 0; i < 10_000; i++) {
      packet.append(i, i % 100, i % 50, i % 2 == 0);
    }
    assertEquals(10_000, packet.size());
    assertTrue(packet.capacity() < 20_001, "it grows by doubling");
    for (int i = 0; i < 10_000; i++) {
      assertEquals(i, packet.timeUs(i));
      assertEquals(EventAddress.pack(i % 100, i % 50, i % 2 == 0), packet.address(i));
    }
  }

  @Test
  void packetCapacityIsLimited() {
    EventPacket packet = new EventPacket(4);
    assertThrows(IllegalArgumentException.class, () -> packet.ensureCapacity((1 << 28) + 1));
    assertThrows(IllegalArgumentException.class, () -> packet.ensureCapacity(-1));
    assertThrows(IllegalArgumentException.class, () -> new EventPacket((1 << 28) + 1));
    assertThrows(IllegalArgumentException.class, () -> new EventPacket(-1));
    assertEquals(4, packet.capacity());
  }

  @Test
  void valuesOutOfRangeAreRejected() {
    EventPacket packet = new EventPacket(0);
    packet.append(10, 0, 0, true);
    assertThrows(IllegalArgumentException.class, () -> packet.append(9, 0, 0, true));
    assertThrows(IllegalArgumentException.class, () -> packet.append(10, -1, 0, true));
    assertThrows(IllegalArgumentException.class, () -> packet.append(10, 0, 0x8000, true));
    assertEquals(1, packet.size());
  }

  @Test
  void filteringInPlaceKeepsTheChosenEventsInOrder() {
    EventPacket packet = new EventPacket(0);
    for (int i = 0; i < 10; i++) {
      packet.append(i, i, 0, true);
    }
    int kept = 0;
    for (int i = 0; i < packet.size(); i++) {
      if (packet.x(i) % 3 == 0) {
        packet.move(i, kept++);
      }
    }
    packet.truncate(kept);
    assertEquals(4, packet.size());
    assertEquals(9, packet.x(3));
    assertEquals(9, packet.lastTimeUs());
    assertThrows(IllegalArgumentException.class, () -> packet.truncate(5));
    assertThrows(IllegalArgumentException.class, () -> packet.truncate(-1));
  }

  @Test
  void wrappedArraysAreNotCopied() {
    long[] timesUs = {1, 2};
    int[] addresses = {3, 4};
    EventPacket packet = EventPacket.of(timesUs, addresses);
    packet.setAddress(0, 5);
    assertEquals(5, addresses[0]);
    assertThrows(IllegalArgumentException.class, () -> EventPacket.of(new long[2], new int[3]));
  }

  @Test
  void eventsOfAnotherPacketAreCopied() {
    EventPacket source = EventPacket.of(new long[] {1, 2, 3}, new int[] {4, 5, 6});
    EventPacket packet = new EventPacket(1);
    packet.append(source, 1, 3);
    source.setAddress(1, 9);
    assertEquals(EventPacket.of(new long[] {2, 3}, new int[] {5, 6}), packet);
    packet.append(packet, 0, 2);
    assertEquals(4, packet.size());
    assertThrows(IndexOutOfBoundsException.class, () -> packet.append(source, 2, 4));
  }

  @Test
  void columnsAreCopiedOut() {
    EventPacket packet = new EventPacket(8);
    packet.append(7, 1, 2, true);
    packet.append(8, 3, 4, false);
    long[] times = new long[3];
    int[] x = new int[3];
    int[] y = new int[3];
    boolean[] on = new boolean[3];
    packet.copyTo(times, x, y, on, 1);
    assertArrayEquals(new long[] {0, 7, 8}, times);
    assertArrayEquals(new int[] {0, 1, 3}, x);
    assertArrayEquals(new int[] {0, 2, 4}, y);
    assertArrayEquals(new boolean[] {false, true, false}, on);
  }

  @Test
  void firstEventAtOrAfterATimeIsFound() {
    EventPacket packet = EventPacket.of(new long[] {1, 3, 3, 5}, new int[4]);
    assertEquals(0, packet.indexAtOrAfter(Long.MIN_VALUE));
    assertEquals(1, packet.indexAtOrAfter(2));
    assertEquals(1, packet.indexAtOrAfter(3));
    assertEquals(3, packet.indexAtOrAfter(4));
    assertEquals(4, packet.indexAtOrAfter(6));
    assertEquals(2, packet.indexAtOrAfter(3, 2));
    packet.truncate(2);
    assertEquals(2, packet.indexAtOrAfter(4));
  }

  @Test
  void packetsAreEqualByEventsNotByCapacity() {
    EventPacket packet = new EventPacket(100);
    packet.append(1, 2, 3, true);
    EventPacket same = new EventPacket(0);
    same.append(1, 2, 3, true);
    assertEquals(packet, same);
    assertEquals(packet.hashCode(), same.hashCode());
    same.append(1, 2, 3, true);
    assertNotEquals(packet, same);
    assertEquals("1 events, 1 to 1 us", packet.toString());
    assertEquals("no events", new EventPacket(3).toString());
  }

  @Test
  void anEmptyPacketHasNoFirstAndNoLastTime() {
    EventPacket packet = new EventPacket(4);
    assertTrue(packet.isEmpty());
    assertThrows(IndexOutOfBoundsException.class, packet::firstTimeUs);
    assertThrows(IndexOutOfBoundsException.class, packet::lastTimeUs);
  }

  @Test
  void decoderSetsTheNumberOfEvents() {
    EventPacket packet = new EventPacket(4);
    packet.timesUs()[0] = 5;
    packet.addresses()[0] = EventAddress.pack(1, 2, true);
    packet.setSize(1);
    assertEquals(5, packet.lastTimeUs());
    assertThrows(IllegalArgumentException.class, () -> packet.setSize(5));
    packet.clear();
    assertTrue(packet.isEmpty());
  }
}
