package haltere.core.simulation.internal.dots;

/** Paths of the dots of {@link MovingDotsScene}, all with constant speed. */
public enum DotPath {
  /** Each on a circle of its own about the middle, neighbours in opposite directions. */
  CIRCLES,
  /** Each in a row of its own, from side to side. */
  LANES,
  /** All through the middle, each in a direction of its own, to and fro, meeting there. */
  CROSSING
}
