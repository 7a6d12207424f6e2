package haltere.core.chain;

/** A filter threw while it worked on a packet: a fault in the filter, named so that it is found. */
public final class FilterFailure extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final transient ChainStage stage;

  FilterFailure(ChainStage stage, RuntimeException cause) {
    super("filter " + stage.name() + " failed: " + cause, cause);
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
