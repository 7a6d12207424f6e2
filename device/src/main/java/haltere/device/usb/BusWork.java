package haltere.device.usb;

import java.nio.IntBuffer;

/**
 * Event handling of a bus: calling the listeners of transfers. A waiting consumer does this itself,
 * which saves a hand-over between threads.
 *
 * <p>Thread rule: all methods may be called from any thread that is not within a listener.
 */
public interface BusWork {
  /** The bus always has its own thread. */
  BusWork ELSEWHERE =
      new BusWork() {
        @Override
        public boolean doFor(long nanos, IntBuffer noMore) {
          return false;
        }

        @Override
        public void interrupt() {
          // no work here
        }
      };

  /**
   * Handles events until one has occurred. Listeners are called on this thread, or on another one
   * that already handles events.
   *
   * @param nanos approximate longest wait; 0 for pending events only
   * @param noMore direct, one number: unless it is 0, there is no wait. A listener may set it;
   *     others call {@link #interrupt} afterwards
   * @return false if this thread may not handle events; it has not waited then
   */
  boolean doFor(long nanos, IntBuffer noMore);

  /** Makes the event-handling threads check their {@code noMore}. */
  void interrupt();
}
