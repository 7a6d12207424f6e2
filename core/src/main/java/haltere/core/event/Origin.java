package haltere.core.event;

/**
 * The corner at which a recording's own pixel coordinates start. Inside Haltere y always points up;
 * this only says what to do when events are exported with the axes of their source.
 *
 * @since 0.1
 */
public enum Origin {
  /** y = 0 is the top row and y points down (AEDAT-4, Prophesee). */
  TOP,
  /** y = 0 is the bottom row and y points up (AEDAT-1, AEDAT-2, everything inside Haltere). */
  BOTTOM
}
