package haltere.core.chain;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorSample;
import haltere.core.overlay.OverlayLayer;
import haltere.core.stream.DataLost;
import haltere.core.stream.Reset;
import haltere.core.stream.SharedWork;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import java.util.List;

/**
 * A stage of the chain: works on each packet in place, and may publish results to its outlets.
 *
 * <p>The contract, which {@code EventFilterContract} tests for every filter:
 *
 * <ul>
 *   <li>what a filter does and publishes does not depend on how the stream is cut into packets;
 *       what should happen at regular times is driven by the times of the events;
 *   <li>after {@link #reset()} it is in the state of a new filter (identities that it has given out
 *       are not given out again, except after {@link #rewind()});
 *   <li>it keeps no reference to a packet after the call, and may drop or change events but not add
 *       or reorder them;
 *   <li>{@link #process} allocates nothing per event, takes no lock and throws nothing for any
 *       packet whose pixels lie on the sensor.
 * </ul>
 *
 * <p>Thread rule: all methods are called on the processing thread.
 *
 * @since 0.1
 */
public interface EventFilter {
  /** Memory of a filter that does not state its own, microseconds: that of a tracker. */
  long DEFAULT_MEMORY_US = 2_000_000;

  /**
   * Works on a packet in place.
   *
   * @param packet borrowed for the length of the call; may be empty
   */
  void process(EventPacket packet);

  /** Forgets everything that events have taught it. */
  void reset();

  /**
   * Begins anew because time went back: as {@link #reset()}, and identities are given out from the
   * first one again, so that the same events lead to the same results.
   */
  default void rewind() {
    reset();
  }

  /**
   * How far back events matter to what the filter does now. A player that jumps to a time runs the
   * chain from so long before it.
   *
   * @return microseconds under the settings in force; 0 for a filter that looks at single events
   */
  default long memoryUs() {
    return DEFAULT_MEMORY_US;
  }

  /**
   * Whether what events have taught it still holds behind a gap in the data, because time goes on
   * over the gap.
   *
   * @return false if it begins anew
   */
  default boolean bridgesGaps() {
    return false;
  }

  /**
   * Is told what happened between the last packet and the next. A filter that holds results to give
   * out at the end overrides this.
   *
   * @param notification what happened; one without meaning for the filter is ignored
   */
  default void notified(StreamNotification notification) {
    boolean isBridged = notification instanceof DataLost && bridgesGaps();
    if (notification instanceof StreamStarted
        || notification instanceof Reset reset && reset.isJump()) {
      rewind();
    } else if (notification.endsContinuity() && !isBridged) {
      reset();
    }
  }

  /**
   * Is shown a frame, an inertial sample or a trigger, at its place among the events. Most filters
   * see polarity events only and leave this as it is.
   *
   * @param sample immutable; it may be kept
   */
  default void sample(SensorSample sample) {}

  /**
   * Where the filter publishes its results.
   *
   * @return always the same outlets
   */
  default List<Outlet<?>> outlets() {
    return List.of();
  }

  /**
   * What can be drawn of the filter's results.
   *
   * @return always the same layers
   */
  default List<OverlayLayer<?>> overlays() {
    return List.of();
  }

  /**
   * Why the filter has no results yet, such as the time it needs first.
   *
   * @return sentences for a person, or an empty text
   */
  default String status() {
    return "";
  }

  /**
   * Is told who does its work, between packets. A filter whose work has pieces that do not touch
   * each other overrides this.
   *
   * @param with does pieces of work, maybe on two threads
   */
  default void share(SharedWork with) {}

  /** Frees what the filter holds; nothing is called after it. */
  default void close() {}
}
