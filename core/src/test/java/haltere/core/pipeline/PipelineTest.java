package haltere.core.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.ChainStage;
import haltere.core.chain.EventFilter;
import haltere.core.chain.FilterChain;
import haltere.core.chain.FilterFailure;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.pipeline.PipelineCounters.Counter;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.testing.MemoryRecording;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;

class PipelineTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(20, 10);

  private final PipelineCounters counters = new PipelineCounters();
  private final FilterChain chain = new FilterChain(SENSOR);
  private final Sink sink = new Sink();

  private static final class Sink implements StreamHandler {
    long events;
    final List<String> notifications = new ArrayList<>();

    @Override
    public void packet(EventPacket packet) {
      events += packet.size();
    }

    @Override
    public void notified(StreamNotification notification) {
      notifications.add(notification.getClass().getSimpleName());
    }
  }

  private static MemoryRecording recording(int events) {
    Random random = new Random(5);
    EventPacket packet = new EventPacket(events);
    for (int i = 0; i < events; i++) {
      // A few pixels lie above the sensor.
      packet.append(i, random.nextInt(20), random.nextInt(11), random.nextBoolean());
    }
    return new MemoryRecording(SENSOR, () -> random.nextInt(300), packet);
  }

  private static EventFilter filter(Consumer<EventPacket> work) {
    return new EventFilter() {
      @Override
      public void process(EventPacket packet) {
        work.accept(packet);
      }

      @Override
      public void reset() {}
    };
  }

  private static void keepOn(EventPacket packet) {
    int kept = 0;
    for (int i = 0; i < packet.size(); i++) {
      if (packet.isOn(i)) {
        packet.move(i, kept++);
      }
    }
    packet.truncate(kept);
  }

  private static void failAt(EventPacket packet, long timeUs) {
    if (!packet.isEmpty() && packet.lastTimeUs() >= timeUs) {
      throw new IllegalArgumentException("cannot do " + timeUs);
    }
  }

  @Test
  void inputEqualsOutputPlusDroppedPlusLost() throws IOException {
    ChainStage on = chain.add("on", filter(PipelineTest::keepOn));
    ChainStage weak = chain.add("weak", filter(packet -> failAt(packet, 6000)));
    List<String> failures =
        Pipeline.run(
            recording(20_000).losing(12_000, 5), chain, List.of(sink), counters, OnFailure.GO_ON);
    assertEquals(1, failures.size());
    assertFalse(weak.isEnabled());
    assertEquals(20_000, counters.get(Counter.EVENTS_IN));
    assertEquals(sink.events, counters.get(Counter.EVENTS_OUT));
    assertEquals(0, counters.unaccountedEvents());
    long lost = counters.get(Counter.EVENTS_LOST_IN_FAILURE);
    assertTrue(lost > 0 && lost < 300);
    assertEquals(chain.outsideSensor(), counters.get(Counter.EVENTS_OUTSIDE_SENSOR));
    assertEquals(0, counters.get(Counter.EVENTS_AT_IMPOSSIBLE_TIMES));
    // The filter itself has seen all but those off the sensor, and dropped what is counted, save
    // what it dropped of the packet that was lost.
    assertEquals(20_000 - chain.outsideSensor(), on.timing().eventsIn());
    long dropped = on.timing().eventsIn() - on.timing().eventsOut();
    assertTrue(dropped >= counters.get(Counter.EVENTS_FILTERED));
    assertTrue(dropped <= counters.get(Counter.EVENTS_FILTERED) + lost);
    assertEquals(5, counters.get(Counter.EVENTS_LOST_BEFORE));
    assertEquals(2, counters.get(Counter.GAPS));
    assertEquals(
        List.of("StreamStarted", "DataLost", "DataLost", "EndOfStream"), sink.notifications);
  }

  @Test
  void failuresStopARunByDefault() {
    chain.add("weak", filter(packet -> failAt(packet, 6000)));
    FilterFailure failure =
        assertThrows(
            FilterFailure.class,
            () -> Pipeline.run(recording(20_000), chain, List.of(sink), counters));
    assertEquals("weak", failure.stage().name());
    assertEquals(0, counters.unaccountedEvents());
    assertFalse(sink.notifications.contains("EndOfStream"));
  }

  @Test
  void failingFilterOfANestedChainIsDisabledAlone() throws IOException {
    FilterChain inner = new FilterChain(SENSOR);
    ChainStage weak = inner.add("weak", filter(packet -> failAt(packet, 6000)));
    ChainStage outer = chain.add("chain", inner);
    Pipeline.run(recording(20_000), chain, List.of(sink), counters, OnFailure.GO_ON);
    assertFalse(weak.isEnabled());
    assertTrue(outer.isEnabled());
  }

  @Test
  void runCanBeInterrupted() {
    chain.add(
        "interrupting",
        filter(
            packet -> {
              if (!packet.isEmpty() && packet.lastTimeUs() >= 100) {
                Thread.currentThread().interrupt();
              }
            }));
    assertThrows(
        InterruptedIOException.class,
        () -> Pipeline.run(recording(20_000), chain, List.of(sink), counters));
    assertTrue(Thread.interrupted());
    assertTrue(sink.events < 1000);
  }

  @Test
  void everyCounterHasADescription() {
    for (Counter counter : Counter.values()) {
      assertTrue(counter.description().matches("[A-Z].*\\."), counter.name());
      assertTrue(counters.toString().contains(counter.description()));
    }
  }
}
