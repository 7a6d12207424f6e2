package haltere.testing;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.Arrays;

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
    return bytesOf(run, -1);
  }

  /**
   * Bytes that a run of code allocates on the calling thread once it is warm, or as soon as several
   * runs in a row allocate no more than is allowed.
   *
   * @param run the code
   * @param allowed bytes of a run
   * @return the least of several runs
   */
  public static long bytesOf(Runnable run, long allowed) {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long thread = Thread.currentThread().getId();
    long[] last = new long[MEASURED_RUNS];
    int inARow = 0;
    for (int i = 0; i < WARM_UP_RUNS + MEASURED_RUNS && inARow < MEASURED_RUNS; i++) {
      long before = threads.getThreadAllocatedBytes(thread);
      run.run();
      long bytes = threads.getThreadAllocatedBytes(thread) - before;
      last[i % MEASURED_RUNS] = bytes;
      inARow = bytes <= allowed ? inARow + 1 : 0;
    }
    return Arrays.stream(last).min().getAsLong();
  }
}
