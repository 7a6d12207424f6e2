package haltere.core.stream.internal;

/** Threads that do not keep a program from ending. */
public final class Daemon {
  private Daemon() {}

  /**
   * A thread that has not started.
   *
   * @param work what it does
   * @param name name in stack traces
   * @return the thread
   */
  public static Thread thread(Runnable work, String name) {
    Thread thread = new Thread(work, name);
    thread.setDaemon(true);
    return thread;
  }
}
