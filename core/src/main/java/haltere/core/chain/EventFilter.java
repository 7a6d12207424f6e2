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
 *   <li>after {@link #reset()} it is in the state of a new filter (identities are not reused,
 *       except after {@link #rewind()});
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
   * Processes a packet in place.
   *
   * @param packet borrowed for the length of the call; may be empty
   */
  void process(EventPacket packet);

  /** Returns to the initial state. */
  void reset();

  /**
   * Resets because time went back: as {@link #reset()}, and identities start from the first one
   * again, so that the same events lead to the same results.
   */
  default void rewind() {
    reset();
  }

  /**
   * Memory of the filter: the time after which an event no longer affects its results. A player
   * that jumps starts its run-up by this time before the target.
   *
   * @return microseconds under the settings in force; 0 for a filter that looks at single events
   */
  default long memoryUs() {
    return DEFAULT_MEMORY_US;
  }

  /**
   * Whether the state stays valid across a gap in the data, because time continues.
   *
   * @return false if a gap resets the filter
   */
  default boolean bridgesGaps() {
    return false;
  }

  /**
   * Receives a notification, between the last packet and the next. A filter that holds results
   * until the end overrides this.
   *
   * @param notification ignored if it has no meaning for the filter
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
   * Receives a frame, an inertial sample or a trigger, at its position among the events. Most
   * filters use polarity events only and do not override this.
   *
   * @param sample immutable; it may be kept
   */
  default void sample(SensorSample sample) {}

  /**
   * Outlets of the filter's results.
   *
   * @return always the same outlets
   */
  default List<Outlet<?>> outlets() {
    return List.of();
  }

  /**
   * Layers that draw the filter's results.
   *
   * @return always the same layers
   */
  default List<OverlayLayer<?>> overlays() {
    return List.of();
  }

  /**
   * Why the filter has no results yet, such as the time it needs first.
   *
   * @return sentences for users, or an empty text
   */
  default String status() {
    return "";
  }

  /**
   * Sets the executor of its work, between packets. A filter whose work has independent pieces
   * overrides this.
   *
   * @param with runs pieces of work, on one thread or two
   */
  default void share(SharedWork with) {}

  /** Frees resources; no other call follows. */
  default void close() {}
}
