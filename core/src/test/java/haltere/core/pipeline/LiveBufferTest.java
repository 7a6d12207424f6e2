package haltere.core.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.DataLost;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamGrammar;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(30)
class LiveBufferTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(4, 4);

  private static LiveBuffer buffer(int events, OverflowPolicy policy) {
    return new LiveBuffer(SENSOR, events, Math.min(4, events), policy, "the buffer");
  }

  private static EventPacket at(long... timesUs) {
    EventPacket packet = new EventPacket(0);
    for (long timeUs : timesUs) {
      packet.append(timeUs, 1, 1, true);
    }
    return packet;
  }

  private static final class Log implements StreamHandler {
    final List<String> lines = new ArrayList<>();
    long events;
    long lost;

    @Override
    public void packet(EventPacket packet) {
      events += packet.size();
      StringBuilder line = new StringBuilder();
      for (int i = 0; i < packet.size(); i++) {
        line.append(packet.timeUs(i)).append(' ');
      }
      lines.add(line.toString().trim());
      // What a chain may do with what it borrows.
      packet.truncate(0);
    }

    @Override
    public void notified(StreamNotification notification) {
      if (notification instanceof DataLost gap) {
        lost += gap.estimatedEvents();
        lines.add("lost " + gap.estimatedEvents() + " " + gap.fromUs() + ".." + gap.toUs());
      } else {
        lines.add(notification.getClass().getSimpleName());
      }
    }
  }

  private static List<String> drained(LiveBuffer buffer) throws IOException {
    Log log = new Log();
    buffer.drainTo(log);
    return log.lines;
  }

  @Test
  void newestPacketsAreDroppedAndReportedAtTheirPosition() throws IOException {
    LiveBuffer buffer = buffer(4, OverflowPolicy.DROP_NEWEST);
    buffer.notified(new StreamStarted(SENSOR, "test"));
    for (long t = 10; t <= 50; t += 10) {
      buffer.packet(at(t, t + 1));
    }
    Log log = new Log();
    for (int i = 0; i < 3; i++) {
      assertTrue(buffer.next(log));
    }
    buffer.packet(at(60));
    buffer.notified(new EndOfStream(60));
    buffer.drainTo(log);
    assertEquals(
        List.of("StreamStarted", "10 11", "20 21", "lost 6 21..60", "60", "EndOfStream"),
        log.lines);
    assertEquals(new LiveBuffer.Counts(11, 5, 6, 0, 2), buffer.counts());
  }

  @Test
  void oldestPacketsAreDroppedAndReportedAtTheirPosition() throws IOException {
    LiveBuffer buffer = buffer(4, OverflowPolicy.DROP_OLDEST);
    buffer.notified(new StreamStarted(SENSOR, "test"));
    for (long t = 10; t <= 50; t += 10) {
      buffer.packet(at(t, t + 1));
    }
    buffer.notified(new EndOfStream(51));
    assertEquals(
        List.of(
            "StreamStarted",
            "lost 6 " + StreamNotification.NO_TIME_US + "..40",
            "40 41",
            "50 51",
            "EndOfStream"),
        drained(buffer));
    assertEquals(new LiveBuffer.Counts(10, 4, 6, 0, 2), buffer.counts());
  }

  @Test
  void notificationsAreNeverDroppedAndLossesKeepTheirOrder() throws IOException {
    LiveBuffer buffer = buffer(2, OverflowPolicy.DROP_OLDEST);
    buffer.notified(new StreamStarted(SENSOR, "test"));
    buffer.packet(at(100));
    buffer.notified(new Reset(Reset.Cause.CLOCK_RESTARTED, 100, 1));
    buffer.packet(at(1));
    buffer.packet(at(2));
    buffer.packet(at(3));
    buffer.packet(at(4));
    buffer.notified(new EndOfStream(4));
    assertEquals(
        List.of(
            "StreamStarted",
            "lost 1 " + StreamNotification.NO_TIME_US + ".." + StreamNotification.NO_TIME_US,
            "Reset",
            "lost 2 " + StreamNotification.NO_TIME_US + "..3",
            "3",
            "4",
            "EndOfStream"),
        drained(buffer));
  }

  @Test
  void manyResetsTakeBoundedMemory() throws IOException {
    LiveBuffer buffer = buffer(2, OverflowPolicy.DROP_NEWEST);
    buffer.notified(new StreamStarted(SENSOR, "test"));
    buffer.packet(at(7));
    for (int i = 0; i < 1000; i++) {
      buffer.notified(new Reset(Reset.Cause.CLOCK_RESTARTED, i == 0 ? 7 : i, i + 1));
    }
    List<StreamNotification> seen = new ArrayList<>();
    buffer.notified(new EndOfStream(7));
    buffer.drainTo(
        new StreamHandler() {
          @Override
          public void packet(EventPacket packet) {}

          @Override
          public void notified(StreamNotification notification) {
            seen.add(notification);
          }
        });
    assertEquals(3, seen.size());
    assertEquals(new Reset(Reset.Cause.CLOCK_RESTARTED, 7, 1000), seen.get(1));
  }

  @Test
  void largePacketsAreSplitAndTheOriginalIsUnchanged() throws IOException {
    LiveBuffer buffer = buffer(12, OverflowPolicy.DROP_NEWEST);
    EventPacket large = at(1, 2, 3, 4, 5, 6, 7, 8, 9);
    buffer.notified(new StreamStarted(SENSOR, "test"));
    buffer.packet(large);
    buffer.notified(new EndOfStream(9));
    assertEquals(
        List.of("StreamStarted", "1 2 3 4", "5 6 7 8", "9", "EndOfStream"), drained(buffer));
    assertEquals(9, large.size());
  }

  @Test
  void capacityCountsEventsNotPackets() throws IOException {
    for (int size : new int[] {1, 10, 100}) {
      for (boolean coalescing : new boolean[] {false, true}) {
        LiveBuffer buffer =
            coalescing
                ? LiveBuffer.coalescing(SENSOR, 1000, 100, OverflowPolicy.DROP_NEWEST, "it")
                : new LiveBuffer(SENSOR, 1000, 100, OverflowPolicy.DROP_NEWEST, "it");
        long timeUs = 0;
        buffer.notified(new StreamStarted(SENSOR, "test"));
        for (int sent = 0; sent < 1500; sent += size) {
          EventPacket packet = new EventPacket(size);
          for (int i = 0; i < size; i++) {
            packet.append(timeUs++, 1, 1, true);
          }
          buffer.packet(packet);
        }
        assertEquals(500, buffer.counts().lost(), size + " " + coalescing);
        buffer.notified(new EndOfStream(timeUs));
        Log log = new Log();
        buffer.drainTo(log);
        assertEquals(1000, log.events);
        assertEquals(500, log.lost);
      }
    }
  }

  @Test
  void aBlockedProducerLosesNothing() throws Exception {
    LiveBuffer buffer = buffer(8, OverflowPolicy.BLOCK);
    Thread producer = produce(buffer, 20_000, 3);
    Log log = new Log();
    buffer.drainTo(new StreamGrammar(log));
    producer.join();
    assertEquals(0, log.lost);
    assertEquals(buffer.counts().in(), log.events);
    assertTrue(buffer.counts().in() > 20_000);
  }

  @Test
  void everyEventIsPassedOnOrReportedLostUnderLoad() throws Exception {
    for (OverflowPolicy policy :
        new OverflowPolicy[] {OverflowPolicy.DROP_NEWEST, OverflowPolicy.DROP_OLDEST}) {
      LiveBuffer buffer = buffer(12, policy);
      Thread producer = produce(buffer, 20_000, 9);
      Log log = new Log();
      buffer.drainTo(new StreamGrammar(log));
      producer.join();
      LiveBuffer.Counts counts = buffer.counts();
      assertEquals(counts.in(), counts.out() + counts.lost());
      assertEquals(counts.out(), log.events);
      assertEquals(counts.lost(), log.lost);
    }
  }

  private static Thread produce(LiveBuffer buffer, int packets, long seed) {
    Thread producer =
        new Thread(
            () -> {
              Random random = new Random(seed);
              long timeUs = 0;
              buffer.notified(new StreamStarted(SENSOR, "test"));
              for (int i = 0; i < packets; i++) {
                EventPacket packet = new EventPacket(8);
                int events = random.nextInt(7);
                for (int k = 0; k < events; k++) {
                  packet.append(timeUs++, 1, 1, true);
                }
                buffer.packet(packet);
                if (random.nextInt(50) == 0) {
                  buffer.notified(new Reset(Reset.Cause.CLOCK_RESTARTED));
                  timeUs = 0;
                }
              }
              buffer.notified(new EndOfStream(timeUs));
            });
    producer.start();
    return producer;
  }

  @Test
  void closingReleasesAWaitingProducer() throws Exception {
    LiveBuffer buffer = buffer(2, OverflowPolicy.BLOCK);
    CountDownLatch full = new CountDownLatch(1);
    Thread producer =
        new Thread(
            () -> {
              buffer.packet(at(1));
              buffer.packet(at(2));
              full.countDown();
              buffer.packet(at(3));
            });
    producer.start();
    full.await();
    buffer.close();
    producer.join();
    assertEquals(3, buffer.counts().lost());
    assertFalse(buffer.next(new Log()));
  }

  @Test
  void interruptEndsTheWaitOfEitherSide() throws Exception {
    LiveBuffer buffer = buffer(2, OverflowPolicy.BLOCK);
    Thread.currentThread().interrupt();
    assertThrows(InterruptedIOException.class, () -> buffer.next(new Log()));
    assertTrue(Thread.interrupted());
    buffer.packet(at(1));
    buffer.packet(at(2));
    Thread.currentThread().interrupt();
    buffer.packet(at(3));
    assertTrue(Thread.interrupted());
    assertEquals(1, buffer.counts().lost());
  }

  @Test
  void poolPacketsCirculateBetweenTwoThreads() throws Exception {
    PacketPool pool = new PacketPool(3, 16);
    Thread producer =
        new Thread(
            () -> {
              try {
                for (int i = 0; i < 5000; i++) {
                  EventPacket packet = pool.take();
                  packet.append(i, 1, 1, true);
                  pool.hand(packet);
                }
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
              }
            });
    producer.start();
    for (int i = 0; i < 5000; i++) {
      EventPacket packet = pool.receive();
      assertEquals(1, packet.size());
      assertEquals(i, packet.timeUs(0));
      pool.release(packet);
    }
    producer.join();
    assertEquals(0, pool.waiting());
    EventPacket one = pool.poll();
    assertTrue(one.isEmpty());
    pool.release(one);
    EventPacket stranger = new EventPacket(1);
    assertThrows(IllegalStateException.class, () -> pool.release(stranger));
  }
}
