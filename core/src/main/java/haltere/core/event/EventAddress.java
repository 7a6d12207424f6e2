package haltere.core.event;

/**
 * The bit layout of a packed event address: bit 31 is 0, bits 30 to 16 are y, bits 15 to 1 are x,
 * bit 0 is 1 for ON and 0 for OFF. Addresses of one sensor therefore order by row, then column.
 *
 * @since 0.1
 */
public final class EventAddress {
  /** The largest coordinate an address can hold. */
  public static final int MAX_COORDINATE = 0x7fff;

  /** Distance of y from bit 0. */
  public static final int Y_SHIFT = 16;

  /** Distance of x from bit 0. */
  public static final int X_SHIFT = 1;

  /** The polarity bit. */
  public static final int ON_BIT = 1;

  private EventAddress() {}

  /**
   * Packs a pixel and a polarity. The coordinates are not checked.
   *
   * @param x column, 0 to {@link #MAX_COORDINATE}
   * @param y row, 0 to {@link #MAX_COORDINATE}
   * @param on true for ON
   * @return the address
   */
  public static int pack(int x, int y, boolean on) {
    return y << Y_SHIFT | x << X_SHIFT | (on ? ON_BIT : 0);
  }

  /**
   * Packs a pixel and a polarity bit. Nothing is checked.
   *
   * @param x column, 0 to {@link #MAX_COORDINATE}
   * @param y row, 0 to {@link #MAX_COORDINATE}
   * @param onBit 1 for ON, 0 for OFF
   * @return the address
   */
  public static int pack(int x, int y, int onBit) {
    return y << Y_SHIFT | x << X_SHIFT | onBit;
  }

  /**
   * Column of an address.
   *
   * @param address a packed address
   * @return x
   */
  public static int x(int address) {
    return (address >>> X_SHIFT) & MAX_COORDINATE;
  }

  /**
   * Row of an address.
   *
   * @param address a packed address
   * @return y
   */
  public static int y(int address) {
    return address >>> Y_SHIFT;
  }

  /**
   * Polarity of an address.
   *
   * @param address a packed address
   * @return true for ON
   */
  public static boolean isOn(int address) {
    return (address & ON_BIT) != 0;
  }
}
