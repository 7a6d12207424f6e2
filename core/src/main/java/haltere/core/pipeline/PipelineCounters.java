package haltere.core.pipeline;

import java.util.Objects;
import java.util.concurrent.atomic.AtomicLongArray;

/**
 * Counters of a run. Each event from the source reached the sinks, was removed by a filter, lay off
 * the sensor or was lost with a failed filter: {@link #unaccountedEvents()} is 0 between two
 * packets.
 *
 * <p>Thread rule: one thread counts, any thread reads.
 *
 * @since 0.1
 */
public final class PipelineCounters {
  /** A counter with its description. */
  public enum Counter {
    /** Packets that the source handed over. */
    PACKETS_IN("Packets from the source."),
    /** Events that the source handed over. */
    EVENTS_IN("Events from the source."),
    /** Events that came out of the chain. */
    EVENTS_OUT("Events that passed the chain to the sinks."),
    /** Events that filters dropped. */
    EVENTS_FILTERED("Events removed by the filters of the chain."),
    /** Events off the sensor. */
    EVENTS_OUTSIDE_SENSOR("Events dropped: pixel not on the sensor."),
    /** Events lost with a failing filter. */
    EVENTS_LOST_IN_FAILURE("Events lost because a filter failed on their packet."),
    /** Events lost before they came in. */
    EVENTS_LOST_BEFORE("Events lost before the chain, as reported by the source."),
    /** Gaps. */
    GAPS("Losses of events, before the chain or in it."),
    /** Resets. */
    RESETS("Resets of the chain."),
    /** Events of run-ups. */
    EVENTS_RUN_UP("Events of run-ups, processed before a moment that was jumped to."),
    /** Failures of filters. */
    FILTER_FAILURES("Filters switched off after a failure."),
    /** Failures of sinks. */
    SINK_FAILURES("Sinks removed after a failure."),
    /** Events at times that no recording has. */
    EVENTS_AT_IMPOSSIBLE_TIMES("Events dropped: impossible time.");

    private final String description;

    Counter(String description) {
      this.description = description;
    }

    /**
     * What it counts.
     *
     * @return a sentence for users
     */
    public String description() {
      return description;
    }
  }

  private final AtomicLongArray values = new AtomicLongArray(Counter.values().length);

  /** Counters at 0. */
  public PipelineCounters() {}

  /**
   * Reads a counter.
   *
   * @param counter which
   * @return its value
   */
  public long get(Counter counter) {
    return values.get(counter.ordinal());
  }

  /**
   * Counts. Only the processing thread does.
   *
   * @param counter which
   * @param count how many, at least 0
   */
  public void add(Counter counter, long count) {
    int index = Objects.requireNonNull(counter, "counter").ordinal();
    values.lazySet(index, values.getPlain(index) + count);
  }

  /**
   * Events that no counter accounts for.
   *
   * @return 0 between two packets, unless Haltere has a fault
   */
  public long unaccountedEvents() {
    return get(Counter.EVENTS_IN)
        - get(Counter.EVENTS_OUT)
        - get(Counter.EVENTS_FILTERED)
        - get(Counter.EVENTS_OUTSIDE_SENSOR)
        - get(Counter.EVENTS_AT_IMPOSSIBLE_TIMES)
        - get(Counter.EVENTS_LOST_IN_FAILURE);
  }

  @Override
  public String toString() {
    StringBuilder text = new StringBuilder();
    for (Counter counter : Counter.values()) {
      text.append(get(counter)).append('\t').append(counter.description()).append('\n');
    }
    return text.toString();
  }
}
