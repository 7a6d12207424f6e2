package haltere.ui.command.terminal;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/**
 * Lets the work end in order when the process is told to stop: the working thread is interrupted,
 * closes its files (which removes what is unfinished) and only then does the process go.
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
   * The work is done, with its status, however it ended. This does not return where the process has
   * been told to stop. It ends with status 0 then if that was a proper end of the work, as of a
   * recording; else with the status of what stopped it (130 for Ctrl+C).
   */
  public void finished(int workStatus) {
    status = workStatus;
    done.countDown();
    if (stopping) {
      // Waits for the exit that is under way; one with the status of a failure would overtake it.
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
