package haltere.filters.wing;

/**
 * An edge of a wing, or a whole wing. The leading edge is the front one in the direction of motion
 * and makes pixels darker (OFF events); the trailing edge makes them brighter (ON events).
 */
public enum WingPart {
  /** Leading edge of the left wing. */
  LEFT_LEADING("left-leading"),
  /** Trailing edge of the left wing. */
  LEFT_TRAILING("left-trailing"),
  /** Leading edge of the right wing. */
  RIGHT_LEADING("right-leading"),
  /** Trailing edge of the right wing. */
  RIGHT_TRAILING("right-trailing"),
  /** The left wing, both edges together. */
  LEFT("left"),
  /** The right wing, both edges together. */
  RIGHT("right");

  private static final WingPart[] EDGES = {
    LEFT_LEADING, LEFT_TRAILING, RIGHT_LEADING, RIGHT_TRAILING
  };

  private final String text;

  WingPart(String text) {
    this.text = text;
  }

  /**
   * An edge of a wing.
   *
   * @param side 0 left, 1 right
   * @param edge 0 leading, 1 trailing
   * @return the edge
   */
  public static WingPart edge(int side, int edge) {
    return EDGES[2 * side + edge];
  }

  /**
   * A wing as a whole.
   *
   * @param side 0 left, 1 right
   * @return the wing
   */
  public static WingPart wing(int side) {
    return side == 0 ? LEFT : RIGHT;
  }

  /** {@return the side of the wing that it is, or is an edge of: 0 left, 1 right} */
  public int sideNumber() {
    return this == RIGHT || this == RIGHT_LEADING || this == RIGHT_TRAILING ? 1 : 0;
  }

  /** {@return whether it is a wing as a whole} */
  public boolean isWing() {
    return this == LEFT || this == RIGHT;
  }

  /** {@return the name in tables, such as {@code left-leading}} */
  @Override
  public String toString() {
    return text;
  }
}
