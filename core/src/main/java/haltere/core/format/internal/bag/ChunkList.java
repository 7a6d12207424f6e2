package haltere.core.format.internal.bag;

/** The chunks of a bag, as far as its index knows them. */
interface ChunkList {
  /** Where the first chunk after a position begins, as far as it is known; else {@link #end}. */
  long chunkAfter(long position);

  /** Where chunks end. */
  long end();

  /** Whether the bag was not closed, or has lost its end. */
  boolean cutOff();
}
