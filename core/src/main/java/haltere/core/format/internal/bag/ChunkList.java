package haltere.core.format.internal.bag;

/** The chunks of a bag that its index lists. */
interface ChunkList {
  /** Start of the first listed chunk after a position; {@link #end} if there is none. */
  long chunkAfter(long position);

  /** End of the chunks. */
  long end();

  /** Whether the bag was not closed, or is truncated. */
  boolean cutOff();
}
