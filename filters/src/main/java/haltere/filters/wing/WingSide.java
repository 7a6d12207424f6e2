package haltere.filters.wing;

/** The side of a wing: left is counterclockwise of the heading. */
public enum WingSide {
  /** Counterclockwise of the heading. */
  LEFT,
  /** Clockwise of the heading. */
  RIGHT;

  /** {@return the name in tables, {@code left} or {@code right}} */
  @Override
  public String toString() {
    return this == LEFT ? "left" : "right";
  }
}
