package haltere.core.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.ChainStage;
import haltere.core.chain.EventFilter;
import haltere.core.chain.FilterChain;
import haltere.core.chain.Outlet;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.json.internal.Json;
import haltere.core.sink.Column;
import haltere.core.sink.LineOutput;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.StreamStarted;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Clock;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class LiveResultsTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(16, 8);

  record Spot(@Column("t_us") long timeUs, int x) {}

  record Spots(List<Spot> all) {}

  /** Publishes every event. */
  private static final class EveryEvent implements EventFilter {
    final Outlet<Spot> spots = new Outlet<>("spots", Spot.class);
    final Outlet<Spots> snapshots = new Outlet<>("snapshots", Spots.class);

    @Override
    public void process(EventPacket packet) {
      for (int i = 0; i < packet.size(); i++) {
        spots.publish(new Spot(packet.timeUs(i), packet.x(i)));
      }
    }

    @Override
    public void reset() {}

    @Override
    public List<Outlet<?>> outlets() {
      return List.of(spots, snapshots);
    }
  }

  /** Keeps lines; takes them only once it is let. */
  private static class Kept implements LineOutput {
    final List<String> lines = new CopyOnWriteArrayList<>();
    final List<String> topics = new CopyOnWriteArrayList<>();
    final CountDownLatch letGo = new CountDownLatch(1);
    final CountDownLatch closed = new CountDownLatch(1);

    Kept(boolean heldUp) {
      if (!heldUp) {
        letGo.countDown();
      }
    }

    @Override
    public String address() {
      return "kept://here:1";
    }

    @Override
    public void send(String topic, byte[] line) {
      try {
        letGo.await();
      } catch (InterruptedException stopped) {
        Thread.currentThread().interrupt();
      }
      topics.add(topic);
      lines.add(new String(line, StandardCharsets.US_ASCII));
    }

    @Override
    public int receivers() {
      return 1;
    }

    @Override
    public long lost() {
      return 0;
    }

    @Override
    public void close() {
      closed.countDown();
    }
  }

  private static EventPacket events(int fromUs, int count) {
    EventPacket packet = new EventPacket(count);
    for (int i = 0; i < count; i++) {
      packet.append(fromUs + i, i % 16, 0, true);
    }
    return packet;
  }

  private static void run(FilterChain chain, LiveResults results, EventPacket packet) {
    ChainRunner runner =
        new ChainRunner(chain, new PipelineCounters(), OnFailure.STOP, failure -> {});
    runner.addSink(results, false);
    runner.notified(new StreamStarted(SENSOR, "test"));
    runner.packet(packet);
    runner.notified(new EndOfStream(packet.lastTimeUs()));
  }

  private static List<Map<?, ?>> parsed(Kept output) throws IOException {
    List<Map<?, ?>> messages = new ArrayList<>();
    for (String line : output.lines) {
      messages.add((Map<?, ?>) Json.parse(line, "a line"));
    }
    return messages;
  }

  @Test
  void outputFailuresAreReportedAtOnceAndQueuedLinesCounted() throws IOException {
    List<String> told = new CopyOnWriteArrayList<>();
    Kept output =
        new Kept(true) {
          @Override
          public Optional<String> failure() {
            return lines.isEmpty() ? Optional.empty() : Optional.of("no network");
          }
        };
    FilterChain chain = new FilterChain(SENSOR);
    chain.add("every-event", new EveryEvent());
    LiveResults results = LiveResults.open(chain, output, name -> true, Clock.systemUTC());
    results.onFailure(told::add);
    chain.process(events(0, 10));
    output.letGo.countDown();
    results.close();
    assertEquals(1, output.lines.size());
    assertEquals(9, results.lost());
    assertEquals(List.of("no network"), told);
  }

  @Test
  void senderFailuresAreReportedAtOnceAndUnsentLinesCounted() throws IOException {
    List<String> told = new CopyOnWriteArrayList<>();
    Kept output =
        new Kept(false) {
          @Override
          public void send(String topic, byte[] line) {
            if (lines.size() == 3) {
              throw new IllegalStateException("no socket");
            }
            super.send(topic, line);
          }
        };
    EveryEvent filter = new EveryEvent();
    FilterChain chain = new FilterChain(SENSOR);
    chain.add("every-event", filter);
    LiveResults results = LiveResults.open(chain, output, name -> true, Clock.systemUTC());
    results.onFailure(told::add);
    chain.process(events(0, 10));
    results.close();
    assertEquals(3, output.lines.size());
    assertEquals(7, results.lost());
    assertEquals(List.of("its sender failed: java.lang.IllegalStateException: no socket"), told);
    assertEquals(told.get(0), results.failure().orElseThrow());
  }

  @Test
  void resultsAndNotificationsAreNumberedInOrder() throws IOException {
    FilterChain chain = new FilterChain(SENSOR);
    chain.add("every-event", new EveryEvent());
    Kept output = new Kept(false);
    try (LiveResults results = LiveResults.open(chain, output, name -> true, Clock.systemUTC())) {
      run(chain, results, events(100, 3));
    }
    List<Map<?, ?>> messages = parsed(output);
    assertEquals(5, messages.size());
    for (int i = 0; i < 5; i++) {
      assertEquals(i + 1L, messages.get(i).get("number"));
    }
    assertEquals("started", messages.get(0).get("notification"));
    assertEquals("every-event/spots", messages.get(1).get("from"));
    assertEquals(Map.of("t_us", 102L, "x", 2L), messages.get(3).get("row"));
    assertEquals("end", messages.get(4).get("notification"));
    assertEquals("every-event/spots", output.topics.get(1));
    assertEquals(0, output.closed.getCount());
  }

  @Test
  void blockedOutputsBlockNoOthersAndLossesAreReported() throws IOException {
    FilterChain chain = new FilterChain(SENSOR);
    chain.add("every-event", new EveryEvent());
    Kept output = new Kept(true);
    LiveResults results = LiveResults.open(chain, output, Clock.systemUTC(), 8);
    run(chain, results, events(0, 1000));
    assertTrue(results.lost() >= 1000 - 16, () -> "lost " + results.lost());
    output.letGo.countDown();
    results.close();
    long whole = 0;
    long missing = 0;
    long expected = 1;
    for (Map<?, ?> message : parsed(output)) {
      if ("lost".equals(message.get("notification"))) {
        missing += (Long) message.get("messages");
        expected += (Long) message.get("messages");
      } else {
        assertEquals(expected++, message.get("number"));
        whole++;
      }
    }
    assertEquals(1002, whole + missing);
    assertEquals(results.lost(), missing);
  }

  @Test
  void withoutReceiversMessagesAreNumberedButNeitherSentNorLost() throws IOException {
    AtomicInteger receivers = new AtomicInteger();
    Kept output =
        new Kept(false) {
          @Override
          public int receivers() {
            return receivers.get();
          }
        };
    FilterChain chain = new FilterChain(SENSOR);
    chain.add("every-event", new EveryEvent());
    LiveResults results = LiveResults.open(chain, output, Clock.systemUTC(), 2);
    chain.process(events(0, 1000));
    receivers.set(1);
    chain.process(events(1000, 1));
    results.close();
    assertEquals(0, results.lost());
    assertEquals(List.of(1001L), parsed(output).stream().map(line -> line.get("number")).toList());
  }

  @Test
  void onlyRequestedOutletsAreSentAndOthersHaveNoSubscriber() throws IOException {
    FilterChain chain = new FilterChain(SENSOR);
    EveryEvent first = new EveryEvent();
    EveryEvent second = new EveryEvent();
    FilterChain nested = new FilterChain(SENSOR);
    nested.add("inner", second);
    chain.add("outer", first);
    chain.add("both", nested);
    assertEquals(List.of("outer/spots", "inner/spots"), LiveResults.outlets(chain));
    Kept output = new Kept(false);
    try (LiveResults results =
        LiveResults.open(chain, output, "inner/spots"::equals, Clock.systemUTC())) {
      assertFalse(first.spots.hasSubscribers());
      run(chain, results, events(0, 2));
    }
    assertEquals(
        List.of("notification", "inner/spots", "inner/spots", "notification"), output.topics);
    assertFalse(second.spots.hasSubscribers());
  }

  @Test
  void addedAndRemovedStagesAreFollowed() throws IOException {
    FilterChain chain = new FilterChain(SENSOR);
    ChainStage old = chain.add("old", new EveryEvent());
    Kept output = new Kept(false);
    try (LiveResults results = LiveResults.open(chain, output, name -> true, Clock.systemUTC())) {
      chain.remove(old);
      chain.add("new", new EveryEvent());
      results.packet(events(0, 1));
      chain.process(events(10, 1));
    }
    assertEquals(List.of("new/spots"), output.topics);
  }
}
