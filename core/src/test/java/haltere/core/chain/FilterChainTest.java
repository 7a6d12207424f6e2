package haltere.core.chain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.DataLost;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class FilterChainTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(10, 8);

  private final FilterChain chain = new FilterChain(SENSOR);
  private final EveryNthFilter first = new EveryNthFilter(EveryNthFilter.Settings.of(2));
  private final EveryNthFilter second = new EveryNthFilter(EveryNthFilter.Settings.of(3));
  private final ChainStage firstStage = chain.add("every-nth", first);
  private final ChainStage secondStage = chain.add("every-nth", second);

  @Test
  void packetPassesThroughFiltersInOrder() {
    EventPacket packet = events(0, 12);
    chain.process(packet);
    assertEquals(List.of("packet of 12"), first.log);
    assertEquals(List.of("packet of 6"), second.log);
    assertEquals(2, packet.size());
    assertEquals(6, packet.lastTimeUs());
  }

  @Test
  void stagesOfOneKindHaveDifferentNames() {
    assertEquals("every-nth", firstStage.name());
    assertEquals("every-nth-2", secondStage.name());
    assertSame(secondStage, chain.stage("every-nth-2"));
    ChainProblem problem = assertThrows(ChainProblem.class, () -> chain.stage("wings"));
    assertEquals(
        "the chain has no stage named wings, it has [every-nth, every-nth-2]",
        problem.getMessage());
  }

  @Test
  void stagesOfNestedChainsHaveDifferentNames() {
    FilterChain outer = new FilterChain(SENSOR);
    FilterChain other = new FilterChain(SENSOR);
    outer.add("a", chain);
    ChainStage inOther = other.add("every-nth", new EveryNthFilter(EveryNthFilter.Settings.of(4)));
    outer.add("b", other);
    outer.add("every-nth", new EveryNthFilter(EveryNthFilter.Settings.of(5)));
    assertEquals(
        List.of("every-nth", "every-nth-2", "every-nth-3", "every-nth-4"),
        outer.innermostStages().stream().map(ChainStage::name).toList());
    assertSame(inOther, other.stage("every-nth-3"));
    ChainStage later = chain.add("every-nth", new EveryNthFilter(EveryNthFilter.Settings.of(6)));
    assertEquals("every-nth-5", later.name());
  }

  @Test
  void filterThatCannotBeCreatedIsNamed() {
    FilterProvider<EveryNthFilter.Settings> broken =
        new EveryNthFilter.Provider() {
          @Override
          public EveryNthFilter create(SensorGeometry geometry, EveryNthFilter.Settings settings) {
            throw new IllegalStateException("no model");
          }
        };
    ChainProblem problem = assertThrows(ChainProblem.class, () -> chain.add(broken));
    assertEquals(
        "the filter every-nth cannot be created: java.lang.IllegalStateException: no model",
        problem.getMessage());
    assertEquals("no model", problem.getCause().getMessage());
    assertEquals(2, chain.stages().size());
  }

  @Test
  void disabledFilterReceivesOnlyNotifications() {
    chain.setEnabled(firstStage, false);
    chain.process(events(0, 12));
    chain.notified(new EndOfStream(11));
    assertEquals(List.of("EndOfStream[lastUs=11]"), first.log);
    assertEquals(List.of("packet of 12", "EndOfStream[lastUs=11]"), second.log);
  }

  @Test
  void reenabledFiltersAreResetBeforeTheNextPacket() {
    chain.process(events(0, 4));
    chain.setEnabled(firstStage, false);
    chain.process(events(4, 4));
    chain.setEnabled(firstStage, true);
    chain.process(events(8, 4));
    assertEquals(
        List.of("packet of 4", new Reset(Reset.Cause.RE_ENABLED, 3, 8).toString(), "packet of 4"),
        first.log);
    assertEquals(List.of("packet of 2", "packet of 4", "packet of 2"), second.log);
  }

  @Test
  void discontinuityReplacesTheResetOfReEnabling() {
    chain.process(events(0, 4));
    chain.setEnabled(firstStage, false);
    chain.setEnabled(firstStage, true);
    chain.notified(new Reset(Reset.Cause.SEEK));
    chain.process(events(8, 4));
    assertEquals(
        List.of("packet of 4", new Reset(Reset.Cause.SEEK).toString(), "packet of 4"), first.log);
  }

  @Test
  void enablingAnEnabledStageChangesNothing() {
    chain.process(events(0, 4));
    chain.setEnabled(firstStage, true);
    chain.process(events(4, 4));
    assertEquals(List.of("packet of 4", "packet of 4"), first.log);
  }

  @Test
  void everyNotificationReachesEveryFilter() {
    List<StreamNotification> notifications =
        List.of(
            new StreamStarted(SENSOR, "a test"),
            new Reset(Reset.Cause.USER),
            new DataLost(1, 1, 0, 1, "the test"),
            new EndOfStream(1));
    notifications.forEach(chain::notified);
    assertEquals(notifications.stream().map(Object::toString).toList(), first.log);
    assertEquals(first.log, second.log);
  }

  @Test
  void streamOfAnotherSensorSizeIsRejected() {
    ChainProblem problem =
        assertThrows(
            ChainProblem.class,
            () -> chain.notified(new StreamStarted(new SensorGeometry(10, 9), "a test")));
    assertEquals(
        "the chain was made for a sensor of 10x8 pixels, the source has 10x9",
        problem.getMessage());
    assertTrue(first.log.isEmpty());
  }

  @Test
  void movingAStageResetsAllStagesWithAnotherInput() {
    EveryNthFilter third = new EveryNthFilter(EveryNthFilter.Settings.of(1));
    ChainStage thirdStage = chain.add("every-nth", third);
    chain.move(thirdStage, 1);
    assertEquals(List.of(firstStage, thirdStage, secondStage), chain.stages());
    assertEquals(List.of(), first.log);
    assertEquals(List.of(new Reset(Reset.Cause.USER).toString()), second.log);
    assertEquals(List.of(new Reset(Reset.Cause.USER).toString()), third.log);
    chain.move(firstStage, 2);
    assertEquals(List.of(thirdStage, secondStage, firstStage), chain.stages());
  }

  @Test
  void removedStagesAreClosedAndLeaveTheChain() {
    chain.remove(firstStage);
    assertTrue(first.closed);
    assertEquals(List.of(secondStage), chain.stages());
    assertThrows(ChainProblem.class, () -> chain.setEnabled(firstStage, false));
    assertThrows(ChainProblem.class, () -> chain.move(firstStage, 0));
    assertThrows(ChainProblem.class, () -> chain.remove(firstStage));
  }

  @Test
  void timingCountsPacketsAndEventsOfEachStage() {
    chain.process(events(0, 12));
    FilterTiming before = secondStage.timing();
    chain.process(events(12, 6));
    assertEquals(2, firstStage.timing().packets());
    assertEquals(18, firstStage.timing().eventsIn());
    assertEquals(9, firstStage.timing().eventsOut());
    assertEquals(9, secondStage.timing().eventsIn());
    assertEquals(3, secondStage.timing().eventsOut());
    assertEquals(1, secondStage.timing().since(before).packets());
    assertEquals(3, secondStage.timing().since(before).eventsIn());
    assertTrue(firstStage.timing().busyNanos() > 0);
  }

  @Test
  void unusedStagesHaveZeroCost() {
    assertEquals(0, firstStage.timing().microsPerThousandEvents());
    assertEquals(2.5, new FilterTiming(1, 1000, 10, 2500).microsPerThousandEvents());
  }

  @Test
  void eventsOutsideOfTheSensorAreDroppedAndCounted() {
    FilterChain empty = new FilterChain(SENSOR);
    EventPacket packet = new EventPacket(0);
    packet.append(0, 9, 7, true);
    packet.append(1, 10, 0, true);
    packet.append(2, 0, 8, true);
    packet.append(3, 0, 0, false);
    packet.append(4, EventAddress.MAX_COORDINATE, EventAddress.MAX_COORDINATE, true);
    empty.process(packet);
    assertEquals(2, packet.size());
    assertEquals(0, packet.timeUs(0));
    assertEquals(3, packet.timeUs(1));
    assertEquals(3, empty.outsideSensor());
  }

  @Test
  void eventsAtImpossibleTimesAreDroppedAndCounted() {
    FilterChain empty = new FilterChain(SENSOR);
    EventPacket packet = new EventPacket(0);
    packet.append(Long.MIN_VALUE + 1, 1, 1, true);
    packet.append(-5, 1, 1, true);
    packet.append(1L << 61, 1, 1, true);
    packet.append((1L << 61) + 1, 1, 1, true);
    packet.append(Long.MAX_VALUE, 1, 1, true);
    empty.process(packet);
    assertEquals(2, packet.size());
    assertEquals(-5, packet.timeUs(0));
    assertEquals(3, empty.atImpossibleTimes());
    assertEquals(0, empty.outsideSensor());
  }

  @Test
  void nestedChainIsAStage() {
    FilterChain outer = new FilterChain(SENSOR);
    ChainStage nested = outer.add("noise", chain);
    EventPacket packet = events(0, 12);
    outer.process(packet);
    assertEquals(2, packet.size());
    assertEquals(2, nested.timing().eventsOut());
    assertEquals(List.of(first.passed, second.passed), outer.outlets());
    outer.setEnabled(nested, false);
    outer.process(events(12, 12));
    outer.setEnabled(nested, true);
    outer.process(events(24, 12));
    assertEquals(
        List.of(
            "packet of 12", new Reset(Reset.Cause.RE_ENABLED, 11, 24).toString(), "packet of 12"),
        first.log);
  }

  @Test
  void innermostStagesAreThoseOfNestedChainsInTheirPlace() {
    FilterChain outer = new FilterChain(SENSOR);
    outer.add("noise", chain);
    ChainStage last = outer.add("last", new EveryNthFilter(EveryNthFilter.Settings.of(2)));
    List<ChainStage> expected = new ArrayList<>(chain.stages());
    expected.add(last);
    assertEquals(expected, outer.innermostStages());
  }

  @Test
  void stageOfANestedChainIsSwitchedThroughTheOuterChain() {
    FilterChain outer = new FilterChain(SENSOR);
    outer.add("noise", chain);
    outer.setEnabled(firstStage, false);
    outer.process(events(0, 12));
    assertEquals(List.of("packet of 12"), second.log);
  }

  @Test
  void filterIsInAChainOnceAndAChainNotInItself() {
    FilterChain outer = new FilterChain(SENSOR);
    outer.add("noise", chain);
    assertThrows(ChainProblem.class, () -> outer.add("again", first));
    assertThrows(ChainProblem.class, () -> chain.add("outer", outer));
    ChainProblem problem = assertThrows(ChainProblem.class, () -> outer.add("itself", outer));
    assertEquals(
        "the filter of itself is in this chain already; create another one", problem.getMessage());
    assertEquals(1, outer.stages().size());
  }

  @Test
  void nestedChainForAnotherSensorIsRejected() {
    FilterChain other = new FilterChain(new SensorGeometry(128, 128));
    ChainProblem problem = assertThrows(ChainProblem.class, () -> other.add("noise", chain));
    assertEquals("a chain for 10x8 pixels does not fit into one for 128x128", problem.getMessage());
  }

  @Test
  void failuresNameTheFilter() {
    FilterChain outer = new FilterChain(SENSOR);
    ChainStage broken =
        chain.add(
            "broken",
            new EventFilter() {
              @Override
              public void process(EventPacket packet) {
                throw new IllegalStateException("no reason");
              }

              @Override
              public void reset() {
                throw new IllegalStateException("no reset either");
              }

              @Override
              public String status() {
                throw new IllegalStateException("no status");
              }
            });
    outer.add("noise", chain);
    FilterFailure failure = assertThrows(FilterFailure.class, () -> outer.process(events(0, 1)));
    assertSame(broken, failure.stage());
    assertEquals(
        "filter broken failed: java.lang.IllegalStateException: no reason", failure.getMessage());
    assertEquals(
        "filter broken failed: java.lang.IllegalStateException: no status",
        assertThrows(FilterFailure.class, outer::status).getMessage());
    EveryNthFilter behind = new EveryNthFilter(EveryNthFilter.Settings.of(1));
    outer.add("every-nth", behind);
    assertThrows(FilterFailure.class, () -> outer.notified(new Reset(Reset.Cause.USER)));
    assertEquals(1, behind.log.size(), "the filters behind are told all the same");
  }

  @Test
  void lackOfMemoryIsNoFailureOfTheFilter() {
    OutOfMemoryError lack = new OutOfMemoryError("Java heap space");
    chain.add(
        "hungry",
        new EventFilter() {
          @Override
          public void process(EventPacket packet) {
            throw lack;
          }

          @Override
          public void reset() {
            throw new StackOverflowError();
          }
        });
    assertSame(lack, assertThrows(OutOfMemoryError.class, () -> chain.process(events(0, 1))));
    Reset reset = new Reset(Reset.Cause.USER);
    FilterFailure failure = assertThrows(FilterFailure.class, () -> chain.notified(reset));
    assertEquals("filter hungry failed: java.lang.StackOverflowError", failure.getMessage());
  }

  @Test
  void settingsOfAnotherTypeAreRejected() {
    chain.apply(firstStage, EveryNthFilter.Settings.of(4));
    assertEquals(4, first.settings().n());
    ChainProblem problem =
        assertThrows(
            ChainProblem.class, () -> chain.apply(firstStage, new FilterTiming(0, 0, 0, 0)));
    assertEquals("stage every-nth does not take FilterTiming", problem.getMessage());
  }

  @Test
  void closingTheChainClosesItsFilters() {
    chain.close();
    assertTrue(first.closed && second.closed);
  }

  private static EventPacket events(long fromUs, int count) {
    EventPacket packet = new EventPacket(count);
    for (int i = 0; i < count; i++) {
      packet.append(fromUs + i, 1, 1, true);
    }
    return packet;
  }
}
