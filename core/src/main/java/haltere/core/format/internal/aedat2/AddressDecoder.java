package haltere.core.format.internal.aedat2;

import haltere.core.event.EventPacket;

/**
 * Converts the address words of one camera to packed event addresses and back, without state.
 *
 * <p>Thread rule: immutable.
 */
abstract sealed class AddressDecoder permits Dvs128AddressDecoder, DavisAddressDecoder {
  /** Result of {@link #address}: not a polarity event (frame, inertial sample, external input). */
  public static final int OTHER = -1;

  /** Result of {@link #address}: a pixel outside the sensor. */
  public static final int OUTSIDE = -2;

  /** Result of {@link #address}: an invalid word in this layout. */
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
   * Decodes a run of regular 8-byte records at once and appends them to a packet: the clock neither
   * wraps nor goes back, and there are no violations except {@link #OTHER}. For an irregular run
   * the packet is unchanged and the caller decodes single records.
   *
   * @param records 8-byte records, address word above, time below
   * @param count their number
   * @param turnUs offset of the 32-bit times
   * @param lastUs time of the previous event
   * @param out packet with room for all of them
   * @return number of records with other data, or -1 for an irregular run
   */
  abstract int decodeRun(long[] records, int count, long turnUs, long lastUs, EventPacket out);
}
