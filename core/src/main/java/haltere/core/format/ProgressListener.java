package haltere.core.format;

/**
 * Receives the progress of a long operation on a recording. To cancel the operation, interrupt its
 * thread.
 *
 * <p>Thread rule: called on the thread that does the work.
 *
 * @since 0.1
 */
@FunctionalInterface
public interface ProgressListener {
  /** Ignores the progress. */
  ProgressListener NONE = (done, total) -> {};

  /**
   * Receives the progress; called often, so it must be cheap.
   *
   * @param doneBytes bytes of the recording processed so far, never descending
   * @param totalBytes bytes of the recording
   */
  void progress(long doneBytes, long totalBytes);
}
