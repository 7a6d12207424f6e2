package haltere.testing;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.EventFilter;
import haltere.core.chain.FilterChain;
import haltere.core.chain.Outlet;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.DataLost;
import haltere.core.stream.DeviceLost;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/**
 * The contract of every {@link EventFilter}. The test of a filter extends this class and creates
 * the filter:
 *
 * <pre>{@code
 * class RefractoryFilterTest extends EventFilterContract {
 *   @Override
 *   protected EventFilter create(SensorGeometry geometry) {
 *     return new RefractoryFilter(geometry, RefractorySettings.defaults());
 *   }
 * }
 * }</pre>
 */
public abstract class EventFilterContract {
  private static final long SECOND_US = 1_000_000;
  private static final SensorGeometry SENSOR = new SensorGeometry(96, 64);
  private static final List<SensorGeometry> SENSORS =
      List.of(
          new SensorGeometry(1, 1), new SensorGeometry(128, 128), new SensorGeometry(1280, 720));

  /**
   * A new filter.
   *
   * @param geometry the sensor whose events it will see
   * @return a filter in its initial state
   */
  protected abstract EventFilter create(SensorGeometry geometry);

  /**
   * A stream on which the filter has something to do; overridden where moving bars are not it.
   *
   * @param geometry the sensor
   * @param seed makes another stream
   * @return events from time 0 on, a second or so
   */
  protected EventPacket stream(SensorGeometry geometry, long seed) {
    return EventPackets.movingBars(geometry, seed, SECOND_US, 0);
  }

  /**
   * A result without identities, which may differ between a new filter and a reset one.
   *
   * @param result what an outlet published
   * @return by default the same
   */
  protected Object withoutIdentity(Object result) {
    return result;
  }

  /**
   * Whether the filter may give an event another pixel or polarity.
   *
   * @return false unless overridden
   */
  protected boolean changesAddresses() {
    return false;
  }

  @Test
  void sameEventsGiveTheSameResults() {
    EventPacket stream = stream(SENSOR, 1);
    Results first = run(create(SENSOR), List.of(EventPackets.copy(stream)));
    Results second = run(create(SENSOR), List.of(EventPackets.copy(stream)));
    assertSame(first, second, "of a second new filter on the same packet");
  }

  @Test
  void resultsDoNotDependOnPacketBoundaries() {
    EventPacket stream = stream(SENSOR, 1);
    Results whole = run(create(SENSOR), List.of(EventPackets.copy(stream)));
    for (long seed = 1; seed <= 20; seed++) {
      Results cut = run(create(SENSOR), EventPackets.cut(stream, seed));
      assertSame(whole, cut, "cut with seed " + seed);
    }
  }

  @Test
  void oneEventPerPacketGivesTheResultsOfASinglePacket() {
    EventPacket all = stream(SENSOR, 2);
    EventPacket stream = EventPackets.part(all, 0, Math.min(20_000, all.size()));
    List<EventPacket> single = new ArrayList<>();
    for (int i = 0; i < stream.size(); i++) {
      single.add(EventPackets.part(stream, i, i + 1));
    }
    Results whole = run(create(SENSOR), List.of(EventPackets.copy(stream)));
    assertSame(whole, run(create(SENSOR), single), "an event a packet");
  }

  @Test
  void resultsDoNotDependOnPacketBoundariesWithTimeJumpsAndNegativeTimes() {
    EventPacket part = stream(SENSOR, 3);
    long[] startsUs = {
      -1L << 60, -SECOND_US * 3600, 0, SECOND_US * 1800, 1L << 31, 1L << 33, 3L << 40, 1L << 60
    };
    EventPacket stream = new EventPacket(0);
    for (long startUs : startsUs) {
      stream.append(EventPackets.shifted(part, startUs), 0, Math.min(3000, part.size()));
    }
    Results whole = run(create(SENSOR), List.of(EventPackets.copy(stream)));
    for (long seed = 1; seed <= 5; seed++) {
      assertSame(whole, run(create(SENSOR), EventPackets.cut(stream, seed)), "seed " + seed);
    }
  }

  @Test
  void resetFilterBehavesLikeANewFilter() {
    EventPacket second = stream(SENSOR, 5);
    Results expected = run(create(SENSOR), List.of(EventPackets.copy(second)));
    EventFilter used = create(SENSOR);
    used.process(EventPackets.shifted(stream(SENSOR, 4), 10 * SECOND_US));
    used.reset();
    assertSame(
        anonymous(expected),
        anonymous(run(used, List.of(EventPackets.copy(second)))),
        "after a reset");
  }

  @Test
  void timeMayDecreaseAfterAnyResetOrStart() {
    EventPacket first = EventPackets.shifted(stream(SENSOR, 4), 10 * SECOND_US);
    EventPacket second = stream(SENSOR, 5);
    Results expected = anonymous(run(create(SENSOR), List.of(EventPackets.copy(second))));
    for (StreamNotification notification : startsAndResets()) {
      EventFilter used = create(SENSOR);
      used.process(EventPackets.copy(first));
      used.notified(notification);
      Results after = run(used, List.of(EventPackets.copy(second)));
      assertSame(expected, anonymous(after), "after " + notification);
    }
  }

  @Test
  void identitiesAreReproducedAfterASeekARewindOrAStart() {
    EventPacket second = stream(SENSOR, 5);
    Results expected = run(create(SENSOR), List.of(EventPackets.copy(second)));
    List<StreamNotification> jumps =
        List.of(
            new Reset(Reset.Cause.SEEK),
            new Reset(Reset.Cause.REWIND),
            new StreamStarted(SENSOR, "a test"));
    for (StreamNotification jump : jumps) {
      EventFilter used = create(SENSOR);
      used.process(EventPackets.shifted(stream(SENSOR, 4), 10 * SECOND_US));
      used.notified(jump);
      assertSame(expected, run(used, List.of(EventPackets.copy(second))), "after " + jump);
    }
  }

  private static List<StreamNotification> startsAndResets() {
    List<StreamNotification> notifications = new ArrayList<>();
    notifications.add(new StreamStarted(SENSOR, "a test"));
    for (Reset.Cause cause : Reset.Cause.values()) {
      notifications.add(new Reset(cause));
      notifications.add(new Reset(cause, 11 * SECOND_US, 0));
    }
    return notifications;
  }

  @Test
  void everyNotificationIsAcceptedAtAnyTime() {
    List<StreamNotification> notifications = new ArrayList<>(startsAndResets());
    notifications.add(new DataLost(512, 128, 1000, 2000, "the test"));
    notifications.add(
        new DataLost(
            -1, -1, StreamNotification.NO_TIME_US, StreamNotification.NO_TIME_US, "the test"));
    notifications.add(new DeviceLost("the test", 1000));
    notifications.add(new EndOfStream(1000));
    notifications.add(new EndOfStream(StreamNotification.NO_TIME_US));
    EventPacket stream = stream(SENSOR, 6);
    for (StreamNotification notification : notifications) {
      EventFilter filter = create(SENSOR);
      assertDoesNotThrow(
          () -> {
            filter.notified(notification);
            for (EventPacket packet : EventPackets.cut(stream, 6)) {
              filter.process(packet);
              filter.notified(notification);
            }
          },
          () -> "on " + notification);
    }
  }

  @Test
  void deviceLossDoesNotChangeResultsOfLaterPackets() {
    EventPacket stream = stream(SENSOR, 7);
    int half = stream.size() / 2;
    Results undisturbed = run(create(SENSOR), List.of(EventPackets.copy(stream)));
    EventFilter filter = create(SENSOR);
    Results results = new Results(filter);
    results.process(filter, EventPackets.part(stream, 0, half));
    filter.notified(new DeviceLost("the test", stream.timeUs(half)));
    results.process(filter, EventPackets.part(stream, half, stream.size()));
    filter.notified(new EndOfStream(stream.lastTimeUs()));
    assertSame(undisturbed, results, "after the loss of the device");
  }

  @Test
  void emptyPacketStaysEmptyAndPublishesNothing() {
    EventFilter filter = create(SENSOR);
    Results results = new Results(filter);
    EventPacket empty = new EventPacket(0);
    filter.process(empty);
    filter.process(empty);
    assertTrue(empty.isEmpty(), "an empty packet was filled");
    assertTrue(results.published.isEmpty(), "published without an event: " + results.published);
  }

  @Test
  void eventsAreNeitherAddedNorReordered() {
    for (SensorGeometry geometry : SENSORS) {
      EventFilter filter = create(geometry);
      EventPacket stream = EventPackets.uniform(geometry, 8, 30_000, 0, 20);
      for (EventPacket packet : EventPackets.cut(stream, 8)) {
        EventPacket before = EventPackets.copy(packet);
        filter.process(packet);
        int next = 0;
        for (int i = 0; i < packet.size(); i++) {
          while (next < before.size() && !same(before, next, packet, i)) {
            next++;
          }
          assertTrue(next < before.size(), "event " + i + " of the result was not in the packet");
          next++;
        }
      }
    }
  }

  private boolean same(EventPacket before, int i, EventPacket after, int j) {
    return before.timeUs(i) == after.timeUs(j)
        && (changesAddresses() || before.address(i) == after.address(j));
  }

  @Test
  void packetsAreNeitherRetainedNorWrittenAfterTheCall() {
    EventPacket stream = stream(SENSOR, 9);
    Results plain = run(create(SENSOR), EventPackets.cut(stream, 9));
    PoisoningChain poisoned = new PoisoningChain(create(SENSOR));
    Results results = run(poisoned, EventPackets.cut(stream, 9));
    poisoned.checkPoison();
    assertSame(plain, results, "with poisoned packets");
  }

  @Test
  void randomEventsOnSmallAndLargeSensorsThrowNothing() {
    SplittableRandom random = new SplittableRandom(10);
    for (SensorGeometry geometry : SENSORS) {
      EventFilter filter = create(geometry);
      long startUs = 0;
      for (int round = 0; round < 20; round++) {
        double stepUs = Math.pow(10, random.nextDouble(-2, 4));
        EventPacket packet =
            EventPackets.uniform(geometry, random.nextLong(), 5_000, startUs, stepUs);
        startUs = packet.lastTimeUs() + random.nextLong(SECOND_US);
        assertDoesNotThrow(() -> filter.process(packet), () -> "on a sensor of " + geometry);
      }
    }
  }

  @Test
  void processingAllocatesNoMemoryPerEvent() {
    EventFilter filter = create(SENSOR);
    EventPacket stream = stream(SENSOR, 11);
    EventPacket packet = new EventPacket(stream.size());
    int passes = Math.max(1, 200_000 / stream.size());
    long bytes =
        Allocation.bytesOf(
            () -> {
              for (int pass = 0; pass < passes; pass++) {
                filter.reset();
                packet.clear();
                packet.append(stream, 0, stream.size());
                filter.process(packet);
              }
            },
            (long) passes * stream.size() - 1);
    double perEvent = (double) bytes / passes / stream.size();
    // The smallest object has 16 bytes. What is left is results, which are made a few times a
    // second.
    assertTrue(perEvent < 1, "bytes allocated per event: " + perEvent);
  }

  @Test
  void disabledFilterLeavesPacketsUnchanged() {
    FilterChain chain = new FilterChain(SENSOR);
    EventFilter filter = create(SENSOR);
    Results results = new Results(filter);
    chain.setEnabled(chain.add("tested", filter), false);
    EventPacket stream = stream(SENSOR, 12);
    EventPacket packet = EventPackets.copy(stream);
    chain.process(packet);
    assertEquals(stream, packet);
    assertTrue(results.published.isEmpty(), "published while disabled: " + results.published);
  }

  /** Output of a filter: its events and, in order, its results. */
  private static final class Results {
    final EventPacket events = new EventPacket(0);
    final List<Object> published = new ArrayList<>();

    Results(EventFilter filter) {
      for (Outlet<?> outlet : filter.outlets()) {
        outlet.subscribe(published::add);
      }
    }

    void process(EventFilter filter, EventPacket packet) {
      filter.process(packet);
      events.append(packet, 0, packet.size());
    }
  }

  private static Results run(EventFilter filter, List<EventPacket> packets) {
    Results results = new Results(filter);
    for (EventPacket packet : packets) {
      results.process(filter, packet);
    }
    filter.notified(new EndOfStream(StreamNotification.NO_TIME_US));
    return results;
  }

  private Results anonymous(Results results) {
    results.published.replaceAll(this::withoutIdentity);
    return results;
  }

  private static void assertSame(Results expected, Results actual, String when) {
    assertEquals(expected.events.toString(), actual.events.toString(), "events " + when);
    assertEquals(expected.events, actual.events, "events " + when);
    assertEquals(expected.published.size(), actual.published.size(), "results published " + when);
    for (int i = 0; i < expected.published.size(); i++) {
      Object one = expected.published.get(i);
      Object other = actual.published.get(i);
      if (!Fingerprint.same(one, other)) {
        assertEquals(Fingerprint.of(one), Fingerprint.of(other), "result " + i + " " + when);
      }
    }
  }
}
