package haltere.testing;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;

/** Measures what a piece of code allocates on the heap. */
public final class Allocation {
  private static final int WARM_UP_RUNS = 30;
  private static final int MEASURED_RUNS = 5;

  private Allocation() {}

  /**
   * Bytes that a run of warmed code allocates on the calling thread.
   *
   * @param run the code
   * @return the least of several runs
   */
  public static long bytesOf(Runnable run) {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    for (int i = 0; i < WARM_UP_RUNS; i++) {
      run.run();
    }
    long least = Long.MAX_VALUE;
    long thread = Thread.currentThread().getId();
    for (int i = 0; i < MEASURED_RUNS; i++) {
      long before = threads.getThreadAllocatedBytes(thread);
      run.run();
      least = Math.min(least, threads.getThreadAllocatedBytes(thread) - before);
    }
    return least;
  }
}
