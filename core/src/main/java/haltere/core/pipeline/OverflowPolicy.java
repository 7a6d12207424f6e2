package haltere.core.pipeline;

/**
 * Treatment of a packet when a queue is full.
 *
 * @since 0.1
 */
public enum OverflowPolicy {
  /** The producer waits: nothing is lost. For recordings. */
  BLOCK,
  /** The packet is dropped; those that wait are kept. For cameras: what is processed is whole. */
  DROP_NEWEST,
  /** The packet that has waited longest is dropped. For what must be up to date. */
  DROP_OLDEST
}
