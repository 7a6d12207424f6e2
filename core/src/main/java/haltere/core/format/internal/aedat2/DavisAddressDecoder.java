package haltere.core.format.internal.aedat2;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;

/**
 * Address words of the DAVIS cameras: bit 31 is 0, bits 22 to 30 are y counted from the bottom,
 * bits 12 to 21 are x counted from the right, bit 11 is 1 for ON. Bit 10 marks an external input,
 * bit 31 a pixel sample of a frame or an inertial sample; neither is an event.
 */
final class DavisAddressDecoder extends AddressDecoder {
  /** Widest sensor that the layout can hold. */
  public static final int MAX_WIDTH = 1024;

  /** Highest sensor that the layout can hold. */
  public static final int MAX_HEIGHT = 512;

  private static final int OTHER_BITS = 0x8000_0400;

  private final int width;
  private final int height;

  /**
   * Decodes for a sensor.
   *
   * @param geometry its size, from which x is mirrored
   */
  public DavisAddressDecoder(SensorGeometry geometry) {
    width = geometry.width();
    height = geometry.height();
  }

  @Override
  public int address(int word) {
    if ((word & OTHER_BITS) != 0) {
      return OTHER;
    }
    int x = width - 1 - (word >>> 12 & 0x3ff);
    int y = word >>> 22;
    return x < 0 || y >= height ? OUTSIDE : EventAddress.pack(x, y, word >>> 11 & 1);
  }

  @Override
  public int word(int address) {
    return EventAddress.y(address) << 22
        | width - 1 - EventAddress.x(address) << 12
        | (address & EventAddress.ON_BIT) << 11;
  }

  @Override
  int decodeRun(long[] records, int count, long turnUs, long lastUs, EventPacket out) {
    long[] times = out.timesUs();
    int[] addresses = out.addresses();
    int start = out.size();
    int size = start;
    int mirror = width - 1;
    int topmost = height - 1;
    long last = lastUs;
    long odd = 0;
    for (int i = 0; i < count; i++) {
      long record = records[i];
      int word = (int) (record >>> 32);
      if ((word & OTHER_BITS) != 0) {
        continue;
      }
      long timeUs = turnUs + (int) record;
      int x = mirror - (word >>> 12 & 0x3ff);
      int y = word >>> 22;
      odd |= (timeUs - last) | x | topmost - y;
      last = timeUs;
      times[size] = timeUs;
      addresses[size++] = y << EventAddress.Y_SHIFT | x << EventAddress.X_SHIFT | word >>> 11 & 1;
    }
    if (odd < 0) {
      return -1;
    }
    out.setSize(size);
    return count - (size - start);
  }
}
