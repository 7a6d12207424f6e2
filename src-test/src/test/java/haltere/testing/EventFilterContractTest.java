package haltere.testing;

import static org.junit.jupiter.api.Assertions.assertThrows;

import haltere.core.chain.EventFilter;
import haltere.core.chain.Outlet;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.DeviceLost;
import haltere.core.stream.StreamNotification;
import java.util.List;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;

/** The contract detects each kind of violation. */
class EventFilterContractTest {
  /** A filter without any state that lets everything through. */
  private static class KeepsTheContract implements EventFilter {
    final Outlet<Long> times = new Outlet<>("times", Long.class);

    @Override
    public void process(EventPacket packet) {
      // Nothing to do.
    }

    @Override
    public void reset() {
      // Nothing to forget.
    }

    @Override
    public List<Outlet<?>> outlets() {
      return List.of(times);
    }
  }

  private static EventFilterContract contractOf(Supplier<EventFilter> filter) {
    return new EventFilterContract() {
      @Override
      protected EventFilter create(SensorGeometry geometry) {
        return filter.get();
      }
    };
  }

  @Test
  void correctFilterMeetsTheContract() {
    EventFilterContract contract = contractOf(KeepsTheContract::new);
    contract.resultsDoNotDependOnPacketBoundaries();
    contract.oneEventPerPacketGivesTheResultsOfASinglePacket();
    contract.resultsDoNotDependOnPacketBoundariesWithTimeJumpsAndNegativeTimes();
    contract.resetFilterBehavesLikeANewFilter();
    contract.timeMayDecreaseAfterAnyResetOrStart();
    contract.everyNotificationIsAcceptedAtAnyTime();
    contract.deviceLossDoesNotChangeResultsOfLaterPackets();
    contract.emptyPacketStaysEmptyAndPublishesNothing();
    contract.eventsAreNeitherAddedNorReordered();
    contract.packetsAreNeitherRetainedNorWrittenAfterTheCall();
    contract.randomEventsOnSmallAndLargeSensorsThrowNothing();
    contract.processingAllocatesNoMemoryPerEvent();
    contract.disabledFilterLeavesPacketsUnchanged();
  }

  @Test
  void filterThatPublishesPerPacketIsDetected() {
    EventFilterContract contract =
        contractOf(
            () ->
                new KeepsTheContract() {
                  @Override
                  public void process(EventPacket packet) {
                    if (!packet.isEmpty()) {
                      times.publish(packet.lastTimeUs());
                    }
                  }
                });
    assertThrows(AssertionError.class, contract::resultsDoNotDependOnPacketBoundaries);
    assertThrows(AssertionError.class, contract::oneEventPerPacketGivesTheResultsOfASinglePacket);
  }

  @Test
  void filterWithIncompleteResetIsDetected() {
    EventFilterContract contract =
        contractOf(
            () ->
                new KeepsTheContract() {
                  private int count;

                  @Override
                  public void process(EventPacket packet) {
                    int kept = 0;
                    for (int i = 0; i < packet.size(); i++) {
                      if (count++ > 100) {
                        packet.move(i, kept++);
                      }
                    }
                    packet.truncate(kept);
                  }
                });
    contract.resultsDoNotDependOnPacketBoundaries();
    assertThrows(AssertionError.class, contract::resetFilterBehavesLikeANewFilter);
    assertThrows(AssertionError.class, contract::timeMayDecreaseAfterAnyResetOrStart);
  }

  @Test
  void filterThatRetainsAPacketIsDetected() {
    EventFilterContract contract =
        contractOf(
            () ->
                new KeepsTheContract() {
                  private long[] kept;

                  @Override
                  public void process(EventPacket packet) {
                    if (!packet.isEmpty()) {
                      times.publish(kept == null ? 0 : kept[0]);
                      kept = packet.timesUs();
                    }
                  }
                });
    assertThrows(AssertionError.class, contract::packetsAreNeitherRetainedNorWrittenAfterTheCall);
  }

  @Test
  void filterThatWritesToAPacketAfterTheCallIsDetected() {
    EventFilterContract contract =
        contractOf(
            () ->
                new KeepsTheContract() {
                  private EventPacket kept;

                  @Override
                  public void process(EventPacket packet) {
                    kept = packet;
                  }

                  @Override
                  public void notified(StreamNotification notification) {
                    if (kept != null && kept.capacity() > 0) {
                      kept.addresses()[0] = 0;
                    }
                  }
                });
    assertThrows(AssertionError.class, contract::packetsAreNeitherRetainedNorWrittenAfterTheCall);
  }

  @Test
  void filterThatAllocatesPerEventIsDetected() {
    EventFilterContract contract =
        contractOf(
            () ->
                new KeepsTheContract() {
                  private final Object[] newest = new Object[16];

                  @Override
                  public void process(EventPacket packet) {
                    for (int i = 0; i < packet.size(); i++) {
                      newest[i % newest.length] = new int[] {packet.address(i)};
                    }
                  }
                });
    assertThrows(AssertionError.class, contract::processingAllocatesNoMemoryPerEvent);
  }

  @Test
  void filterThatAddsOrChangesEventsIsDetected() {
    EventFilterContract adding =
        contractOf(
            () ->
                new KeepsTheContract() {
                  @Override
                  public void process(EventPacket packet) {
                    if (!packet.isEmpty()) {
                      packet.append(packet.lastTimeUs(), packet.address(0));
                    }
                  }
                });
    assertThrows(AssertionError.class, adding::eventsAreNeitherAddedNorReordered);
    EventFilterContract changing =
        contractOf(
            () ->
                new KeepsTheContract() {
                  @Override
                  public void process(EventPacket packet) {
                    for (int i = 0; i < packet.size(); i++) {
                      packet.setAddress(i, 0);
                    }
                  }
                });
    assertThrows(AssertionError.class, changing::eventsAreNeitherAddedNorReordered);
  }

  @Test
  void filterThatFailsOnNotificationsOrPacketSizesIsDetected() {
    EventFilterContract contract =
        contractOf(
            () ->
                new KeepsTheContract() {
                  @Override
                  public void process(EventPacket packet) {
                    times.publish(0L);
                    if (packet.size() > 3000) {
                      throw new IllegalStateException("too many");
                    }
                  }

                  @Override
                  public void notified(StreamNotification notification) {
                    if (notification instanceof DeviceLost) {
                      throw new IllegalStateException("no idea what to do");
                    }
                  }
                });
    assertThrows(AssertionError.class, contract::everyNotificationIsAcceptedAtAnyTime);
    assertThrows(AssertionError.class, contract::emptyPacketStaysEmptyAndPublishesNothing);
    assertThrows(AssertionError.class, contract::randomEventsOnSmallAndLargeSensorsThrowNothing);
  }
}
