package haltere.device.usb;

import java.nio.IntBuffer;

/**
 * The work of a bus: calling the listeners of transfers. A waiting consumer does this itself, so
 * that data need not pass from one thread to another.
 *
 * <p>Thread rule: all methods may be called from any thread that is not within a listener.
 */
public interface BusWork {
  /** The bus works on a thread of its own always. */
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
   * Works until something has happened on the bus. Listeners are called on this thread, or on
   * another one if that works already.
   *
   * @param nanos at most about so long; with 0, does only what there is to do
   * @param noMore direct, one number: where it is not 0, nothing is waited for. A listener may set
   *     it; whoever else does calls {@link #interrupt} then
   * @return false if this thread may not work; it has neither worked nor waited then
   */
  boolean doFor(long nanos, IntBuffer noMore);

  /** Has the threads that work look at their {@code noMore}. */
  void interrupt();
}
