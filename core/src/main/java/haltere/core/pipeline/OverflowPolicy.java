package haltere.core.pipeline;

/**
 * Treatment of a packet when a queue is full.
 *
 * @since 0.1
 */
public enum OverflowPolicy {
  /** The producer waits: nothing is lost. For recordings. */
  BLOCK,
  /**
   * The new packet is dropped; waiting ones stay. For cameras: the processed stream is complete up
   * to the gap.
   */
  DROP_NEWEST,
  /** The packet that has waited longest is dropped. For what must be up to date. */
  DROP_OLDEST
}
