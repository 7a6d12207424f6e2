package haltere.filters.frequency;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.util.Arrays;

/**
 * Event rate and repetition frequency of a region, from counts in the last bins of {@value #BIN_US}
 * microseconds.
 *
 * <p>Thread rule: one thread at a time.
 *
 * @since 0.1
 */
public final class RegionMeter implements StreamHandler {
  /** Length of a bin, for frequencies up to 2.5 kHz. */
  public static final int BIN_US = 200;

  /** Number of bins for frequencies down to 5 Hz: 0.8 s. */
  public static final int BINS = 4096;

  /** Number of bins for the rate, 0.1 s. */
  private static final int RATE_BINS = 500;

  private static final long NONE = Long.MIN_VALUE;

  private final PixelRegion region;
  private final int bins;
  private final int[] on;
  private final int[] off;

  /** Created at the first request of a frequency. */
  private Periodicity periodicity;

  private float[] ordered;
  private long firstBin = NONE;
  private long newestBin = NONE;

  /**
   * A meter without events.
   *
   * @param region the pixels
   */
  public RegionMeter(PixelRegion region) {
    this(region, BINS);
  }

  /**
   * A meter without events.
   *
   * @param region the pixels
   * @param bins number of stored bins, at least 2
   */
  public RegionMeter(PixelRegion region, int bins) {
    this.region = region;
    this.bins = bins;
    on = new int[bins];
    off = new int[bins];
  }

  /**
   * The pixels.
   *
   * @return as given
   */
  public PixelRegion region() {
    return region;
  }

  @Override
  public void packet(EventPacket packet) {
    int size = packet.size();
    if (size == 0) {
      return;
    }
    long[] times = packet.timesUs();
    int[] addresses = packet.addresses();
    int left = region.left();
    int bottom = region.bottom();
    int width = region.width();
    int height = region.height();
    if (firstBin == NONE) {
      firstBin = Math.floorDiv(times[0], BIN_US);
      newestBin = firstBin;
    }
    for (int i = 0; i < size; i++) {
      int address = addresses[i];
      int x = EventAddress.x(address) - left;
      int y = EventAddress.y(address) - bottom;
      if (x >= 0 && x < width && y >= 0 && y < height) {
        advanceTo(times[i]);
        int slot = slotOf(newestBin);
        if (EventAddress.isOn(address)) {
          on[slot]++;
        } else {
          off[slot]++;
        }
      }
    }
    advanceTo(times[size - 1]);
  }

  @Override
  public void notified(StreamNotification notification) {
    if (notification.restartsTime()) {
      Arrays.fill(on, 0);
      Arrays.fill(off, 0);
      firstBin = NONE;
      newestBin = NONE;
    }
  }

  /**
   * Advances time without events.
   *
   * @param timeUs time on the source's clock; an earlier one has no effect
   */
  public void advanceTo(long timeUs) {
    if (newestBin == NONE) {
      return;
    }
    long bin = Math.floorDiv(timeUs, BIN_US);
    if (bin - newestBin >= bins) {
      Arrays.fill(on, 0);
      Arrays.fill(off, 0);
      newestBin = bin;
    }
    while (newestBin < bin) {
      int slot = slotOf(++newestBin);
      on[slot] = 0;
      off[slot] = 0;
    }
  }

  private int slotOf(long bin) {
    return (int) Math.floorMod(bin, (long) bins);
  }

  /**
   * Rate and frequency of the region.
   *
   * @param withFrequency whether the frequency is computed, which takes about a millisecond
   * @return of the stored bins
   */
  public RegionMeasurement measure(boolean withFrequency) {
    if (newestBin == NONE) {
      return RegionMeasurement.NOTHING;
    }
    // the newest bin is not complete
    int known = (int) Math.min(bins - 1, newestBin - firstBin);
    int counted = Math.max(1, Math.min(RATE_BINS, known));
    long onEvents = 0;
    long all = 0;
    for (long bin = newestBin - counted; bin < newestBin; bin++) {
      int slot = slotOf(bin);
      onEvents += on[slot];
      all += on[slot] + off[slot];
    }
    double rateEps = all * 1e6 / ((double) counted * BIN_US);
    double onShare = all == 0 ? Double.NaN : (double) onEvents / all;
    return new RegionMeasurement(
        rateEps, onShare, withFrequency ? frequencyHz(known) : Double.NaN, (long) known * BIN_US);
  }

  private double frequencyHz(int known) {
    if (periodicity == null) {
      periodicity = new Periodicity(bins);
      ordered = new float[bins];
    }
    for (int i = 0; i < known; i++) {
      int slot = slotOf(newestBin - known + i);
      ordered[i] = on[slot] + off[slot];
    }
    double periodBins = periodicity.periodOf(ordered, known);
    return 1e6 / (periodBins * BIN_US);
  }
}
