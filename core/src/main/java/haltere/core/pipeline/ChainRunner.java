package haltere.core.pipeline;

import haltere.core.chain.FilterChain;
import haltere.core.chain.FilterFailure;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorSample;
import haltere.core.pipeline.PipelineCounters.Counter;
import haltere.core.stream.DataLost;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import haltere.core.stream.internal.Reason;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.function.Predicate;

/**
 * Passes a stream to the sinks before the chain, through the chain, and to the sinks after it, and
 * accounts for every event. During a run-up only sinks that follow run-ups receive the stream, and
 * its events are not counted as played.
 *
 * <p>Thread rule: the processing thread only, except {@link #edit}.
 *
 * @since 0.1
 */
public final class ChainRunner implements StreamHandler {
  private final FilterChain chain;
  private final PipelineCounters counters;
  private final OnFailure onFailure;
  private final Consumer<String> failures;
  private final List<StreamHandler> rawSinks = new CopyOnWriteArrayList<>();
  private final List<StreamHandler> sinks = new CopyOnWriteArrayList<>();
  private final ChainEdits edits = new ChainEdits();
  private final Predicate<StreamHandler> followsRunUps;
  private boolean runUp;
  private StreamStarted running;
  private long lastUs = StreamNotification.NO_TIME_US;

  /**
   * A runner without sinks.
   *
   * @param chain the filters
   * @param counters of the run
   * @param onFailure reaction to an exception of a filter or a sink
   * @param failures receives each failure in one line
   */
  public ChainRunner(
      FilterChain chain,
      PipelineCounters counters,
      OnFailure onFailure,
      Consumer<String> failures) {
    this(chain, counters, onFailure, failures, sink -> false);
  }

  /**
   * A runner without sinks that can make run-ups.
   *
   * @param chain the filters
   * @param counters of the run
   * @param onFailure reaction to an exception of a filter or a sink
   * @param failures receives each failure in one line
   * @param followsRunUps whether a sink also receives the stream of run-ups
   */
  public ChainRunner(
      FilterChain chain,
      PipelineCounters counters,
      OnFailure onFailure,
      Consumer<String> failures,
      Predicate<StreamHandler> followsRunUps) {
    this.followsRunUps = Objects.requireNonNull(followsRunUps, "followsRunUps");
    this.chain = Objects.requireNonNull(chain, "chain");
    this.counters = Objects.requireNonNull(counters, "counters");
    this.onFailure = Objects.requireNonNull(onFailure, "onFailure");
    this.failures = Objects.requireNonNull(failures, "failures");
  }

  /**
   * Adds a sink; if a stream is running, it receives its start.
   *
   * @param sink receives the stream
   * @param raw true for before the chain; such a sink must not change packets
   */
  public void addSink(StreamHandler sink, boolean raw) {
    Objects.requireNonNull(sink, "sink");
    List<StreamHandler> list = raw ? rawSinks : sinks;
    list.add(sink);
    if (running != null) {
      guarded(list, sink, handler -> handler.notified(running));
    }
  }

  /**
   * Removes a sink, before or after the chain.
   *
   * @param sink one that was added
   */
  public void removeSink(StreamHandler sink) {
    rawSinks.remove(sink);
    sinks.remove(sink);
  }

  /**
   * Changes the chain before its next packet or notification, on the processing thread. The stream
   * continues if the change throws, such as for a setting out of its range; the failure is then
   * reported in one line.
   *
   * @param change changes the chain; may be passed from any thread
   * @return completed when applied; what the change throws fails the future
   */
  public CompletableFuture<Void> edit(Consumer<FilterChain> change) {
    return edits.add(Objects.requireNonNull(change, "change"));
  }

  /**
   * Whether a stream runs.
   *
   * @return true between its start and its end
   */
  public boolean streamRunning() {
    return running != null;
  }

  /**
   * Time of the last event since continuity ended.
   *
   * @return microseconds, or {@link StreamNotification#NO_TIME_US}
   */
  public long lastUs() {
    return lastUs;
  }

  /**
   * Begins or ends a run-up.
   *
   * @param on whether the following events are a run-up
   */
  public void setRunUp(boolean on) {
    runUp = on;
    chain.setRunUp(on);
  }

  /**
   * Whether a run-up is under way.
   *
   * @return true from its start to its end
   */
  public boolean isRunUp() {
    return runUp;
  }

  @Override
  public void packet(EventPacket packet) {
    edits.applyTo(chain, failures);
    int in = packet.size();
    if (runUp) {
      counters.add(Counter.EVENTS_RUN_UP, in);
    } else {
      counters.add(Counter.PACKETS_IN, 1);
      counters.add(Counter.EVENTS_IN, in);
    }
    deliver(packet, rawSinks);
    long beforeUs = lastUs;
    if (in > 0) {
      lastUs = packet.lastTimeUs();
    }
    if (!throughChain(packet, in, beforeUs)) {
      return;
    }
    if (!runUp) {
      counters.add(Counter.EVENTS_OUT, packet.size());
    }
    deliver(packet, sinks);
  }

  private void deliver(EventPacket packet, List<StreamHandler> list) {
    for (StreamHandler sink : list) {
      try {
        if (!runUp || followsRunUps.test(sink)) {
          sink.packet(packet);
        }
      } catch (RuntimeException thrown) {
        sinkFailed(list, sink, thrown);
      }
    }
  }

  private boolean throughChain(EventPacket packet, int in, long beforeUs) {
    long outsideBefore = chain.outsideSensor();
    long impossibleBefore = chain.atImpossibleTimes();
    FilterFailure failure = null;
    try {
      chain.process(packet);
    } catch (FilterFailure thrown) {
      failure = thrown;
    }
    long outside = chain.outsideSensor() - outsideBefore;
    long impossible = chain.atImpossibleTimes() - impossibleBefore;
    long filtered = in - outside - impossible;
    if (!runUp) {
      counters.add(Counter.EVENTS_OUTSIDE_SENSOR, outside);
      counters.add(Counter.EVENTS_AT_IMPOSSIBLE_TIMES, impossible);
      if (failure == null) {
        counters.add(Counter.EVENTS_FILTERED, filtered - packet.size());
      } else {
        counters.add(Counter.EVENTS_LOST_IN_FAILURE, filtered);
      }
    }
    if (failure != null) {
      filterFailed(failure);
      lose(new DataLost(-1, filtered, beforeUs, StreamNotification.NO_TIME_US, where(failure)));
    }
    return failure == null;
  }

  private static String where(FilterFailure failure) {
    return "filter " + failure.stage().name();
  }

  private void lose(DataLost lost) {
    counters.add(Counter.GAPS, runUp ? 0 : 1);
    notifyChain(lost);
    toAll(sinks, handler -> handler.notified(lost));
  }

  @Override
  public void notified(StreamNotification notification) {
    edits.applyTo(chain, failures);
    if (notification instanceof StreamStarted started) {
      running = started;
    } else if (notification instanceof EndOfStream) {
      running = null;
    } else if (!runUp) {
      count(notification);
    }
    if (notification.endsContinuity()) {
      lastUs = StreamNotification.NO_TIME_US;
    }
    toAll(rawSinks, handler -> handler.notified(notification));
    notifyChain(notification);
    toAll(sinks, handler -> handler.notified(notification));
  }

  private void count(StreamNotification notification) {
    if (notification instanceof Reset) {
      counters.add(Counter.RESETS, 1);
    } else if (notification instanceof DataLost lost) {
      counters.add(Counter.GAPS, 1);
      counters.add(Counter.EVENTS_LOST_BEFORE, Math.max(0, lost.estimatedEvents()));
    }
  }

  /** {@inheritDoc} The filters and the sinks before and after them receive the same sample. */
  @Override
  public void sample(SensorSample sample) {
    toAll(rawSinks, handler -> handler.sample(sample));
    try {
      chain.sample(sample);
    } catch (FilterFailure failure) {
      filterFailed(failure);
    }
    toAll(sinks, handler -> handler.sample(sample));
  }

  /**
   * Calls an action with each sink, those before the chain first; during a run-up only with sinks
   * that follow it.
   *
   * @param action an exception counts as a failure of the sink
   */
  public void forEachSink(Consumer<StreamHandler> action) {
    toAll(rawSinks, action);
    toAll(sinks, action);
  }

  private void toAll(List<StreamHandler> list, Consumer<StreamHandler> action) {
    for (StreamHandler sink : list) {
      if (!runUp || followsRunUps.test(sink)) {
        guarded(list, sink, action);
      }
    }
  }

  private void notifyChain(StreamNotification notification) {
    try {
      chain.notified(notification);
    } catch (FilterFailure failure) {
      filterFailed(failure);
    }
  }

  private void filterFailed(FilterFailure failure) {
    counters.add(Counter.FILTER_FAILURES, 1);
    report(failure.getMessage(), "it is switched off");
    if (onFailure == OnFailure.STOP) {
      throw failure;
    }
    chain.setEnabled(failure.stage(), false);
  }

  private void report(String failure, String consequence) {
    String line = failure.lines().findFirst().orElse("");
    failures.accept(onFailure == OnFailure.STOP ? line : line + "; " + consequence);
  }

  private void guarded(
      List<StreamHandler> list, StreamHandler sink, Consumer<StreamHandler> action) {
    try {
      action.accept(sink);
    } catch (RuntimeException thrown) {
      sinkFailed(list, sink, thrown);
    }
  }

  private void sinkFailed(List<StreamHandler> list, StreamHandler sink, RuntimeException thrown) {
    counters.add(Counter.SINK_FAILURES, 1);
    // a disk that is full is no fault of the program, whose type would help
    Object reason = thrown instanceof UncheckedIOException ? Reason.of(thrown) : thrown;
    report("sink " + name(sink) + " failed: " + reason, "it is removed");
    if (onFailure == OnFailure.STOP) {
      throw thrown;
    }
    list.remove(sink);
  }

  /** The name of a sink's class; that of an anonymous class has its enclosing class. */
  private static String name(StreamHandler sink) {
    String simple = sink.getClass().getSimpleName();
    String full = sink.getClass().getName();
    return simple.isEmpty() ? full.substring(full.lastIndexOf('.') + 1) : simple;
  }
}
