package haltere.device.simulated;

import haltere.core.playback.Sleeper;
import haltere.core.stream.internal.Daemon;
import java.util.function.Consumer;

/**
 * Advances the time of a simulated camera on its own thread, independent of the consumer.
 *
 * <p>Thread rule: all methods may be called from any thread.
 */
final class Heartbeat {
  private final SimulatedTransfers transfers;
  private final Consumer<Throwable> failed;
  private final Sleeper sleeper = Sleeper.real();
  private final Thread thread;
  private boolean started;

  /**
   * A heartbeat that is not started.
   *
   * @param transfers created when due
   * @param name of the camera
   * @param failed called on its thread if the scene fails
   */
  Heartbeat(SimulatedTransfers transfers, String name, Consumer<Throwable> failed) {
    this.transfers = transfers;
    this.failed = failed;
    thread = Daemon.thread(this::run, "haltere-" + name);
  }

  synchronized void start() {
    if (!started) {
      started = true;
      thread.start();
    }
  }

  /** Wakes the thread after the camera was plugged in or closed. */
  void wake() {
    sleeper.wake();
  }

  private void run() {
    try {
      while (!transfers.isOver()) {
        transfers.makeDue();
        sleeper.sleep(transfers.untilNextNanos());
      }
    } catch (InterruptedException ignored) {
      Thread.currentThread().interrupt();
    } catch (RuntimeException | Error thrown) {
      failed.accept(thrown);
    }
  }
}
