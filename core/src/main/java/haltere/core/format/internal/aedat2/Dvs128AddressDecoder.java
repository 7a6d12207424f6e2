package haltere.core.format.internal.aedat2;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;

/**
 * Address words of the DVS128 and of its forerunner Tmpdiff128: bit 0 is 0 for ON and 1 for OFF,
 * bits 1 to 7 are x counted from the right, bits 8 to 14 are y counted from the bottom. Bit 15 or
 * bit 31 marks an external input.
 */
public final class Dvs128AddressDecoder extends AddressDecoder {
  private static final int SPECIAL_BITS = 0x8000_8000;
  private static final int PIXEL_BITS = 0x7fff;

  private final SensorGeometry geometry;
  private final boolean whole;

  /**
   * Decodes for a sensor.
   *
   * @param geometry 128x128, or less to skip the rest
   */
  public Dvs128AddressDecoder(SensorGeometry geometry) {
    this.geometry = geometry;
    whole = geometry.width() >= 128 && geometry.height() >= 128;
  }

  @Override
  public int address(int word) {
    if ((word & SPECIAL_BITS) != 0) {
      return OTHER;
    }
    if ((word & ~PIXEL_BITS) != 0) {
      return UNKNOWN;
    }
    int address = pixel(word);
    if (!whole && !geometry.contains(EventAddress.x(address), EventAddress.y(address))) {
      return OUTSIDE;
    }
    return address;
  }

  /** One exclusive or mirrors bits 1 to 7 and inverts bit 0; bits 8 to 14 move to y. */
  private static int pixel(int word) {
    return (word & 0x7f00) << 8 | ((word ^ 0xff) & 0xff);
  }

  @Override
  public int word(int address) {
    return (address >>> 8 & 0x7f00) | ((address ^ 0xff) & 0xff);
  }

  @Override
  int decodeRun(long[] records, int count, long turnUs, long lastUs, EventPacket out) {
    if (!whole) {
      return -1;
    }
    long[] times = out.timesUs();
    int[] addresses = out.addresses();
    int size = out.size();
    long last = lastUs;
    long odd = 0;
    for (int i = 0; i < count; i++) {
      long record = records[i];
      int word = (int) (record >>> 32);
      long timeUs = turnUs + (int) record;
      odd |= (timeUs - last) | -(long) (word >>> 15);
      last = timeUs;
      times[size + i] = timeUs;
      addresses[size + i] = pixel(word);
    }
    if (odd < 0) {
      return -1;
    }
    out.setSize(size + count);
    return 0;
  }
}
