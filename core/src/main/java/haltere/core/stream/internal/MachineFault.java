package haltere.core.stream.internal;

/** Errors of the Java virtual machine, for which the code that they stopped is not to blame. */
public final class MachineFault {
  private MachineFault() {}

  /**
   * Throws an error of the machine again, such as a lack of memory. Exhaustion of the stack is a
   * fault of the code.
   *
   * @param thrown any failure; others return normally
   */
  public static void rethrow(Throwable thrown) {
    if (thrown instanceof VirtualMachineError fault && !(thrown instanceof StackOverflowError)) {
      throw fault;
    }
  }
}
