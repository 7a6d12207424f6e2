package haltere.ui.command.terminal;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/**
 * Ends the work in order at termination of the process: interrupts the working thread, which closes
 * its files and removes unfinished ones, before the process exits.
 */
public final class Interruption extends Thread {
  private static final long PATIENCE_S = 10;

  private final Thread worker;
  private final CountDownLatch done = new CountDownLatch(1);
  private volatile boolean stopping;
  private volatile int status;

  private Interruption(Thread worker) {
    super("interruption");
    this.worker = worker;
  }

  /** Guards the calling thread's work. */
  public static Interruption install() {
    Interruption interruption = new Interruption(Thread.currentThread());
    Runtime.getRuntime().addShutdownHook(interruption);
    return interruption;
  }

  /**
   * The work has ended with a status. Does not return if the process is to stop: it exits with 0 if
   * that was a proper end of the work, as of a recording; else with the status of the signal (130
   * for Ctrl+C).
   */
  public void finished(int workStatus) {
    status = workStatus;
    done.countDown();
    if (stopping) {
      // Waits for the pending exit; an exit with a failure status would precede it.
      System.exit(0);
    }
  }

  @Override
  public void run() {
    if (done.getCount() == 0) {
      return;
    }
    stopping = true;
    worker.interrupt();
    try {
      if (done.await(PATIENCE_S, TimeUnit.SECONDS) && status == 0) {
        Runtime.getRuntime().halt(0);
      }
    } catch (InterruptedException hurried) {
      Thread.currentThread().interrupt();
    }
  }
}
