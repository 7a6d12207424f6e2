package haltere.core.stream;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorSample;
import java.util.function.Consumer;

/**
 * Receives a stream: packets, samples and notifications, one at a time, in order, on the processing
 * thread.
 *
 * @since 0.1
 */
public interface StreamHandler {
  /**
   * Receives the next packet. It is borrowed: it must not be stored after the call.
   *
   * @param packet events in ascending time
   */
  void packet(EventPacket packet);

  /**
   * Receives the next notification; handlers may ignore it.
   *
   * @param notification what happened between the last packet and the next one
   */
  default void notified(StreamNotification notification) {}

  /**
   * Receives a frame, an inertial sample or a trigger, after all events before its time and before
   * all events at or after it, as exactly as the source orders them. Sources pass samples only on
   * request; handlers may ignore them.
   *
   * @param sample immutable; it may be stored
   */
  default void sample(SensorSample sample) {}

  /**
   * A handler of samples only.
   *
   * @param consumer of samples
   * @return a handler
   */
  static StreamHandler ofSamples(Consumer<SensorSample> consumer) {
    return new StreamHandler() {
      @Override
      public void packet(EventPacket packet) {
        // events are ignored
      }

      @Override
      public void sample(SensorSample sample) {
        consumer.accept(sample);
      }
    };
  }
}
