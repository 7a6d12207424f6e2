package haltere.core.batch;

import haltere.core.chain.ChainProblem;
import haltere.core.chain.FilterFailure;
import haltere.core.format.RecordingProblem;
import haltere.core.json.JsonProblem;
import haltere.core.settings.SettingsProblem;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Locale;
import java.util.Objects;

/**
 * A recording of a batch that has no result.
 *
 * @param item the recording
 * @param kind the kind of failure
 * @param cause one line for users
 * @since 0.1
 */
public record BatchFailure(BatchItem item, FailureKind kind, String cause) {
  /** Kinds of failures. */
  public enum FailureKind {
    /** The recording cannot be understood, or is damaged and has to be whole. */
    RECORDING,
    /** The chain does not fit the recording. */
    CHAIN,
    /** Reading or writing failed. */
    FILES,
    /** A filter failed. */
    FILTER,
    /** There was not enough memory. */
    MEMORY,
    /** The program has a fault. */
    PROGRAM;

    /**
     * The kind of a failure.
     *
     * @param thrown by a job
     * @return never null
     */
    public static FailureKind of(Throwable thrown) {
      if (thrown instanceof UncheckedIOException wrapped) {
        return of(wrapped.getCause());
      }
      if (thrown instanceof RecordingProblem) {
        return thrown.getCause() instanceof IOException ? FILES : RECORDING;
      }
      if (thrown instanceof ChainProblem
          || thrown instanceof SettingsProblem
          || thrown instanceof JsonProblem) {
        return CHAIN;
      }
      if (thrown instanceof IOException) {
        return FILES;
      }
      if (thrown instanceof FilterFailure) {
        return FILTER;
      }
      return thrown instanceof OutOfMemoryError ? MEMORY : PROGRAM;
    }

    @Override
    public String toString() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  /** Checks the values. */
  public BatchFailure {
    Objects.requireNonNull(item, "item");
    Objects.requireNonNull(kind, "kind");
    Objects.requireNonNull(cause, "cause");
  }
}
