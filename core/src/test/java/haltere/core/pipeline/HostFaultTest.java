package haltere.core.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.ChainProblem;
import haltere.core.chain.FilterChain;
import haltere.core.chain.FilterFailure;
import haltere.core.chain.Outlet;
import haltere.core.chain.PublishingFilter;
import haltere.core.event.EventPacket;
import haltere.core.event.InertialSample;
import haltere.core.event.SensorGeometry;
import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsProblem;
import haltere.core.settings.Unit;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Faults of a host stay with the host. */
@Timeout(60)
class HostFaultTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(16, 16);

  /** Settings of {@link Counter}. */
  record CounterSettings(
      @Range(min = 1, max = 100) @Unit("events") @Help("Events of a report.") int every) {
    static CounterSettings defaults() {
      return new CounterSettings(1);
    }
  }

  /** Publishes how many events have come. */
  private static final class Counter extends PublishingFilter<CounterSettings> {
    final Outlet<Long> counts = outlet("counts", Long.class);
    CounterSettings settings = CounterSettings.defaults();
    long events;
    int closings;
    Runnable atWork = () -> {};

    @Override
    public void process(EventPacket packet) {
      atWork.run();
      for (int i = 0; i < packet.size(); i++) {
        if (++events % settings.every() == 0) {
          counts.publish(events);
        }
      }
    }

    @Override
    public void reset() {
      events = 0;
    }

    @Override
    public void close() {
      closings++;
    }

    @Override
    public CounterSettings settings() {
      return settings;
    }

    @Override
    public void apply(CounterSettings applied) {
      settings = applied;
    }
  }

  private final Counter counter = new Counter();
  private final FilterChain chain = new FilterChain(SENSOR);

  HostFaultTest() {
    chain.add("counter", counter);
  }

  private static EventPacket packet(long timeUs, int events) {
    EventPacket packet = new EventPacket(events);
    for (int i = 0; i < events; i++) {
      packet.append(timeUs + i, 1, 1, true);
    }
    return packet;
  }

  @Test
  void throwingSubscribersAreReportedAndRemovedAndTheFilterContinues() {
    List<Long> heard = new ArrayList<>();
    List<RuntimeException> reported = new ArrayList<>();
    counter.counts.subscribe(
        count -> {
          throw new IllegalStateException("a fault of the host");
        },
        reported::add);
    counter.counts.subscribe(heard::add);
    chain.process(packet(0, 3));
    assertEquals(List.of(1L, 2L, 3L), heard);
    assertEquals(1, reported.size());
    assertEquals("a fault of the host", reported.get(0).getMessage());
  }

  @Test
  void concurrentUseOfAChainNamesTheOwningThread() throws Exception {
    CountDownLatch working = new CountDownLatch(1);
    CountDownLatch seen = new CountDownLatch(1);
    counter.atWork =
        () -> {
          working.countDown();
          awaitQuietly(seen);
        };
    Thread worker = new Thread(() -> chain.process(packet(0, 1)), "the-worker");
    worker.start();
    working.await();
    for (Runnable touch :
        List.<Runnable>of(
            () -> chain.process(packet(0, 1)),
            () -> chain.add("another", new Counter()),
            () -> chain.setEnabled(chain.stages().get(0), false),
            () -> chain.set("counter", "every", 2),
            () -> chain.sample(new InertialSample(0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0)),
            chain::reset,
            chain::close)) {
      ChainProblem problem = assertThrows(ChainProblem.class, touch::run);
      assertTrue(problem.getMessage().contains("the-worker"), problem.getMessage());
      assertTrue(problem.getMessage().contains("ChainRunner.edit"), problem.getMessage());
    }
    seen.countDown();
    worker.join();
    chain.process(packet(10, 1));
    assertEquals(2, counter.events);
  }

  private static void awaitQuietly(CountDownLatch latch) {
    try {
      latch.await();
    } catch (InterruptedException stopped) {
      Thread.currentThread().interrupt();
    }
  }

  @Test
  void queuedChangesAreAppliedBeforeTheNextPacket() {
    ChainRunner runner =
        new ChainRunner(chain, new PipelineCounters(), OnFailure.STOP, failure -> {});
    runner.packet(packet(0, 1));
    CompletableFuture.runAsync(() -> runner.edit(own -> own.set("counter", "every", 7))).join();
    assertEquals(1, counter.settings.every());
    runner.packet(packet(10, 1));
    assertEquals(7, counter.settings.every());
  }

  @Test
  void changeThatThrowsIsReportedAndTheStreamContinues() {
    List<String> failures = new ArrayList<>();
    ChainRunner runner =
        new ChainRunner(chain, new PipelineCounters(), OnFailure.STOP, failures::add);
    CompletableFuture<Void> wrong = runner.edit(own -> own.set("counter", "every", 0));
    CompletableFuture<Void> right = runner.edit(own -> own.set("counter", "every", 7));
    runner.packet(packet(0, 7));
    assertInstanceOf(
        SettingsProblem.class, assertThrows(CompletionException.class, wrong::join).getCause());
    right.join();
    assertEquals(7, counter.events);
    assertEquals(7, counter.settings.every());
    assertEquals(
        List.of("a change of the chain failed: setting every is 0, it must be 1 to 100 events"),
        failures);
  }

  @Test
  void failureThatEndsARunIsNotSaidToSwitchTheFilterOff() {
    List<String> failures = new ArrayList<>();
    counter.atWork =
        () -> {
          throw new IllegalStateException("no such pixel");
        };
    ChainRunner runner =
        new ChainRunner(chain, new PipelineCounters(), OnFailure.STOP, failures::add);
    assertThrows(FilterFailure.class, () -> runner.packet(packet(0, 1)));
    assertEquals(
        List.of("filter counter failed: java.lang.IllegalStateException: no such pixel"), failures);
    assertTrue(chain.stages().get(0).isEnabled());
  }

  @Test
  void closedChainIsRefused() {
    chain.close();
    chain.close();
    for (Runnable use :
        List.<Runnable>of(
            () -> chain.process(packet(0, 1)),
            () -> chain.add("another", new Counter()),
            chain::reset)) {
      ChainProblem problem = assertThrows(ChainProblem.class, use::run);
      assertEquals("the chain is closed; create another one", problem.getMessage());
    }
    assertEquals(1, counter.closings);
  }

  @Test
  void settingIsChangedByItsName() {
    chain.set("counter", "every", 12);
    assertEquals(12, counter.settings.every());
    assertThrows(SettingsProblem.class, () -> chain.set("counter", "every", 0));
    assertThrows(SettingsProblem.class, () -> chain.set("counter", "nothing", 1));
    assertThrows(ChainProblem.class, () -> chain.set("nobody", "every", 1));
    assertEquals(12, counter.settings.every());
  }

  @Test
  void sinkFailuresEndTheRunAfterTheFilters() {
    ResultFailure failure = new ResultFailure();
    counter.counts.subscribe(
        count -> {
          throw new IllegalStateException("no space left");
        },
        failure);
    ChainRunner runner = new ChainRunner(chain, new PipelineCounters(), OnFailure.STOP, line -> {});
    runner.addSink(failure, false);
    IllegalStateException thrown =
        assertThrows(IllegalStateException.class, () -> runner.packet(packet(0, 5)));
    assertEquals("no space left", thrown.getMessage());
    assertEquals(5, counter.events);
  }
}
