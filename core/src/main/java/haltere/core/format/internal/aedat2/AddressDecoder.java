package haltere.core.format.internal.aedat2;

import haltere.core.event.EventPacket;

/**
 * Turns the address words of one camera into packed event addresses and back. Pure: the same words
 * give the same addresses.
 *
 * <p>Thread rule: immutable.
 */
abstract sealed class AddressDecoder permits Dvs128AddressDecoder, DavisAddressDecoder {
  /** Answer of {@link #address}: no polarity event (frame, inertial sample, external input). */
  public static final int OTHER = -1;

  /** Answer of {@link #address}: a pixel that is not on the sensor. */
  public static final int OUTSIDE = -2;

  /** Answer of {@link #address}: a word that means nothing in this layout. */
  public static final int UNKNOWN = -3;

  AddressDecoder() {}

  /**
   * Decodes a word.
   *
   * @param word address word of a record
   * @return packed address ({@link haltere.core.event.EventAddress}), or {@link #OTHER}, {@link
   *     #OUTSIDE} or {@link #UNKNOWN}
   */
  public abstract int address(int word);

  /**
   * Encodes an event.
   *
   * @param address packed address of a pixel on the sensor
   * @return address word of a record
   */
  public abstract int word(int address);

  /**
   * Decodes a run of 8-byte records at once, appending to a packet, as long as nothing is odd about
   * them: the clock neither wraps nor goes back, and there is nothing to count but {@link #OTHER}.
   * If something is odd the packet stays as it was and the caller goes record by record.
   *
   * @param records 8-byte records, address word above, time below
   * @param count how many of them
   * @param turnUs what to add to the 32-bit times
   * @param lastUs time of the event before
   * @param out packet with room for all of them
   * @return number of records that held another kind of data, or -1 if something is odd
   */
  abstract int decodeRun(long[] records, int count, long turnUs, long lastUs, EventPacket out);
}
