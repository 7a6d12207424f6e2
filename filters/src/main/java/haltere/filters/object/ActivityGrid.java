package haltere.filters.object;

import haltere.core.event.SensorGeometry;

/**
 * Which pixels fired within the present tick, by tiles of 4 × 4 pixels. A pixel counts once a tick,
 * so that filled, outlined and flickering surfaces count alike. An event costs one load and, if its
 * pixel is new, one store.
 *
 * <p>A tile is one long: 16 bits of pixels, 20 bits of their summed times within the tick in
 * microseconds, 28 bits of the number of the tick.
 *
 * <p>Thread rule: one thread at a time.
 */
final class ActivityGrid {
  static final int TILE_SHIFT = 2;
  static final int TILE_PIXELS = 1 << 2 * TILE_SHIFT;
  private static final int TIME_SHIFT = TILE_PIXELS;
  private static final int TICK_SHIFT = 36;
  private static final int TICK_MASK = (1 << (Long.SIZE - TICK_SHIFT)) - 1;
  private static final int TIME_MASK = (1 << (TICK_SHIFT - TIME_SHIFT)) - 1;
  private static final int IN_TILE = (1 << TILE_SHIFT) - 1;

  final int columns;
  final int rows;
  private final long[] tiles;
  private final int[] active;
  private int count;
  private int tick = 1;

  ActivityGrid(SensorGeometry geometry) {
    columns = (geometry.width() + IN_TILE) >> TILE_SHIFT;
    rows = (geometry.height() + IN_TILE) >> TILE_SHIFT;
    tiles = new long[columns * rows];
    active = new int[tiles.length];
  }

  /** Adds an event at a time since the start of the tick, microseconds. */
  void add(int x, int y, int sinceUs) {
    int tile = (y >> TILE_SHIFT) * columns + (x >> TILE_SHIFT);
    long state = tiles[tile];
    if ((int) (state >>> TICK_SHIFT) != tick) {
      state = (long) tick << TICK_SHIFT;
      active[count++] = tile;
    }
    long bit = 1L << ((y & IN_TILE) << TILE_SHIFT | x & IN_TILE);
    if ((state & bit) == 0) {
      tiles[tile] = (state | bit) + ((long) sinceUs << TIME_SHIFT);
    }
  }

  /** Begins the next tick: no pixel has fired. */
  void next() {
    count = 0;
    tick = tick == TICK_MASK ? 1 : tick + 1;
  }

  /** Tiles in which a pixel fired. */
  int count() {
    return count;
  }

  /** One of these tiles, row by row from the origin. */
  int tile(int index) {
    return active[index];
  }

  /** Column of the first pixel of a tile. */
  int x(int tile) {
    return (tile % columns) << TILE_SHIFT;
  }

  /** Row of the first pixel of a tile. */
  int y(int tile) {
    return (tile / columns) << TILE_SHIFT;
  }

  /** Column of a pixel within its tile. */
  static int pixelX(int pixel) {
    return pixel & IN_TILE;
  }

  /** Row of a pixel within its tile. */
  static int pixelY(int pixel) {
    return pixel >> TILE_SHIFT;
  }

  /** Pixels of a tile that fired: bit 4 y + x. */
  int pixels(int tile) {
    return (int) (tiles[tile] & 0xffff);
  }

  /** Mean time of the pixels that fired, seconds since the start of the tick. */
  double meanS(int tile) {
    long state = tiles[tile];
    return 1e-6 * (state >> TIME_SHIFT & TIME_MASK) / Long.bitCount(state & 0xffff);
  }
}
