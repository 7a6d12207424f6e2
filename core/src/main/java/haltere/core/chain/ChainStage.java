package haltere.core.chain;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorSample;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.internal.MachineFault;
import java.util.Objects;

/**
 * A stage of a chain: a filter, whether it is enabled, and its processor time.
 *
 * <p>Thread rule: as the chain, but {@link #timing()}, {@link #isEnabled()} and the names may be
 * read from any thread.
 *
 * @since 0.1
 */
public final class ChainStage {
  private final String kind;
  private final EventFilter filter;
  private volatile String name;
  private volatile boolean enabled;
  private volatile FilterTiming timing = FilterTiming.NONE;
  private long packets;
  private long eventsIn;
  private long eventsOut;
  private long busyNanos;
  private long lastSeenUs = StreamNotification.NO_TIME_US;
  private boolean resetPending;

  ChainStage(String name, String kind, EventFilter filter, boolean enabled) {
    this.name = Objects.requireNonNull(name, "name");
    this.kind = Objects.requireNonNull(kind, "kind");
    this.filter = Objects.requireNonNull(filter, "filter");
    this.enabled = enabled;
  }

  /**
   * Name of the stage, unique in its chain, in the chains nested in it and in those around it. If
   * its chain becomes nested in a chain with a stage of this name, it gets another name.
   *
   * @return the filter's name, with a number if there are several of them
   */
  public String name() {
    return name;
  }

  /**
   * Name of the filter's provider.
   *
   * @return as {@link FilterProvider#name()}, or {@code chain} for a nested chain
   */
  public String kind() {
    return kind;
  }

  /**
   * The filter.
   *
   * @return the same filter at each call
   */
  public EventFilter filter() {
    return filter;
  }

  /**
   * Whether packets go through the filter.
   *
   * @return false if they bypass it
   */
  public boolean isEnabled() {
    return enabled;
  }

  /**
   * Processor time and event counts up to the last packet.
   *
   * @return a snapshot
   */
  public FilterTiming timing() {
    return timing;
  }

  void rename(String other) {
    name = other;
  }

  void setEnabled(boolean on) {
    if (on && !enabled) {
      resetPending = true;
    }
    enabled = on;
  }

  void process(EventPacket packet) {
    int in = packet.size();
    if (resetPending) {
      notified(
          new Reset(
              Reset.Cause.RE_ENABLED,
              lastSeenUs,
              in == 0 ? StreamNotification.NO_TIME_US : packet.firstTimeUs()));
    }
    if (in > 0) {
      lastSeenUs = packet.lastTimeUs();
    }
    long start = System.nanoTime();
    try {
      filter.process(packet);
    } catch (RuntimeException | Error thrown) {
      throw failure(thrown);
    }
    busyNanos += System.nanoTime() - start;
    packets++;
    eventsIn += in;
    eventsOut += packet.size();
    timing = new FilterTiming(packets, eventsIn, eventsOut, busyNanos);
  }

  void notified(StreamNotification notification) {
    if (notification.endsContinuity()) {
      resetPending = false;
      lastSeenUs = StreamNotification.NO_TIME_US;
    }
    try {
      filter.notified(notification);
    } catch (RuntimeException | Error thrown) {
      throw failure(thrown);
    }
  }

  void sample(SensorSample sample) {
    try {
      filter.sample(sample);
    } catch (RuntimeException | Error thrown) {
      throw failure(thrown);
    }
  }

  String status() {
    try {
      return filter.status();
    } catch (RuntimeException | Error thrown) {
      throw failure(thrown);
    }
  }

  private FilterFailure failure(Throwable thrown) {
    MachineFault.rethrow(thrown);
    return thrown instanceof FilterFailure named ? named : new FilterFailure(this, thrown);
  }

  @Override
  public String toString() {
    return name + (enabled ? "" : " (off)");
  }
}
