package haltere.filters.object;

import haltere.core.event.SensorGeometry;

/**
 * Pixels that fired within the present tick, by tiles of 4 × 4 pixels. A pixel counts once a tick,
 * so that surfaces, contours and flickering pixels count alike. An event changes its tile and the
 * index of tiles without a branch.
 *
 * <p>Sixteen consecutive tiles are a block of 16 × 16 pixels. A tile is one long: 16 bits of pixels
 * and above them their summed times within the tick in microseconds.
 */
final class ActivityGrid {
  private static final int SHIFT = 2;
  static final int TILE_PX = 1 << SHIFT;
  static final int TILE_PIXELS = 1 << 2 * SHIFT;
  static final int BLOCK_SHIFT = 2 * SHIFT;
  private static final int TIME_SHIFT = TILE_PIXELS;
  private static final int MASK = (1 << SHIFT) - 1;

  /** Columns and rows of blocks. */
  final int columns;

  final int rows;

  private final long[] tiles;

  /** A bit for each tile in which a pixel fired. */
  private final long[] fired;

  /** 2<sup>32</sup> by the columns, rounded up: a product instead of a division. */
  private final long perColumns;

  ActivityGrid(SensorGeometry geometry) {
    columns = (geometry.width() - 1 >> BLOCK_SHIFT) + 1;
    rows = (geometry.height() - 1 >> BLOCK_SHIFT) + 1;
    tiles = new long[columns * rows << BLOCK_SHIFT];
    fired = new long[tiles.length / Long.SIZE + 1];
    perColumns = (1L << Integer.SIZE) / columns + 1;
  }

  /** Number of tiles. */
  int tiles() {
    return tiles.length;
  }

  /** Adds an event at a time since the start of the tick, microseconds. */
  void add(int x, int y, int sinceUs) {
    int block = (y >> BLOCK_SHIFT) * columns + (x >> BLOCK_SHIFT);
    int tile = block << BLOCK_SHIFT | (y >> SHIFT & MASK) << SHIFT | x >> SHIFT & MASK;
    int pixel = (y & MASK) << SHIFT | x & MASK;
    long state = tiles[tile];
    long isFirst = (state >>> pixel & 1) - 1;
    tiles[tile] = (state | 1L << pixel) + ((long) sinceUs << TIME_SHIFT & isFirst);
    fired[tile / Long.SIZE] |= 1L << tile;
  }

  /** Starts the next tick. */
  void next() {
    for (int word = 0; word < fired.length; word++) {
      for (long left = fired[word]; left != 0; left &= left - 1) {
        tiles[word * Long.SIZE + Long.numberOfTrailingZeros(left)] = 0;
      }
      fired[word] = 0;
    }
  }

  /**
   * The first tile in which a pixel fired, block by block.
   *
   * @param from first candidate
   * @return -1 if there is none
   */
  int nextTile(int from) {
    int word = from / Long.SIZE;
    long left = fired[word] & -1L << from;
    while (left == 0) {
      if (++word == fired.length) {
        return -1;
      }
      left = fired[word];
    }
    return word * Long.SIZE + Long.numberOfTrailingZeros(left);
  }

  /** Column of the first pixel of a tile. */
  int x(int tile) {
    int block = tile >> BLOCK_SHIFT;
    return block - row(block) * columns << BLOCK_SHIFT | pixelX(tile) << SHIFT;
  }

  /** Row of the first pixel of a tile. */
  int y(int tile) {
    return row(tile >> BLOCK_SHIFT) << BLOCK_SHIFT | pixelY(tile) << SHIFT;
  }

  private int row(int block) {
    return (int) (block * perColumns >>> Integer.SIZE);
  }

  /** Column of a pixel within its tile, or of a tile within its block. */
  static int pixelX(int pixel) {
    return pixel & MASK;
  }

  /** Row of a pixel within its tile, or of a tile within its block. */
  static int pixelY(int pixel) {
    return pixel >> SHIFT & MASK;
  }

  /** Pixels of a tile that fired: bit 4 y + x. */
  int pixels(int tile) {
    return (int) (tiles[tile] & 0xffff);
  }

  /** Mean time of the pixels that fired, seconds since the start of the tick. */
  double meanS(int tile) {
    long state = tiles[tile];
    return 1e-6 * (state >> TIME_SHIFT) / Long.bitCount(state & 0xffff);
  }
}
