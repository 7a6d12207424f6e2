package haltere.core.batch;

import java.util.List;

/**
 * The report of a batch.
 *
 * @param done recordings with a new result
 * @param kept recordings with a valid earlier result
 * @param elsewhere recordings on which another process works
 * @param failures recordings without a result, in the order of their names
 * @param events events of the recordings that were done
 * @param bytes size of the recordings that were done
 * @param rows rows of the tables that were written
 * @since 0.1
 */
public record BatchReport(
    int done,
    int kept,
    int elsewhere,
    List<BatchFailure> failures,
    long events,
    long bytes,
    long rows) {
  /** Copies the list. */
  public BatchReport {
    failures = List.copyOf(failures);
  }
}
