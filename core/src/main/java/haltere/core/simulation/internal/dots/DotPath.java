package haltere.core.simulation.internal.dots;

/** How the dots of {@link MovingDotsScene} move. All keep their speed. */
public enum DotPath {
  /** Each on a circle of its own about the middle, neighbours in opposite directions. */
  CIRCLES,
  /** Each in a row of its own, from side to side. */
  LANES,
  /** All through the middle, each in a direction of its own, to and fro, meeting there. */
  CROSSING
}
