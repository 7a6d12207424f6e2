package haltere.core.stream;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorSample;
import java.util.function.Consumer;

/**
 * Takes a stream: packets, samples and notifications, one at a time, in order, on the processing
 * thread.
 *
 * @since 0.1
 */
public interface StreamHandler {
  /**
   * Takes the next packet. It is borrowed: it must not be kept after the call.
   *
   * @param packet events in ascending time
   */
  void packet(EventPacket packet);

  /**
   * Takes the next notification. One that means nothing to the handler is ignored.
   *
   * @param notification what happened between the last packet and the next one
   */
  default void notified(StreamNotification notification) {}

  /**
   * Takes a frame, an inertial sample or a trigger: it comes after all events before its time and
   * before all events at or after it, as near as the source has it. Sources give them only if they
   * are asked to. One that means nothing to the handler is ignored, and nobody has to take any.
   *
   * @param sample immutable; it may be kept
   */
  default void sample(SensorSample sample) {}

  /**
   * A handler that takes what stands between the events and nothing else.
   *
   * @param consumer of frames, inertial samples and triggers
   * @return a handler
   */
  static StreamHandler ofSamples(Consumer<SensorSample> consumer) {
    return new StreamHandler() {
      @Override
      public void packet(EventPacket packet) {
        // only what stands between the events is wanted
      }

      @Override
      public void sample(SensorSample sample) {
        consumer.accept(sample);
      }
    };
  }
}
