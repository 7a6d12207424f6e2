package haltere.core.chain;

import haltere.core.stream.internal.Reason;
import java.io.UncheckedIOException;

/**
 * An exception or error of a filter while it worked on a packet, with the name of its stage.
 *
 * @since 0.1
 */
public final class FilterFailure extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final transient ChainStage stage;

  FilterFailure(ChainStage stage, Throwable cause) {
    super(
        cause instanceof UncheckedIOException
            ? "results of filter " + stage.name() + " were lost: " + Reason.of(cause)
            : "filter " + stage.name() + " failed: " + cause,
        cause);
    this.stage = stage;
  }

  /**
   * The stage whose filter failed.
   *
   * @return the stage, so that it can be disabled
   */
  public ChainStage stage() {
    return stage;
  }
}
