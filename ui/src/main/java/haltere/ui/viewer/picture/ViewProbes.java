package haltere.ui.viewer.picture;

import haltere.core.event.EventPacket;
import haltere.core.stream.StreamNotification;
import haltere.filters.frequency.PixelRegion;
import haltere.filters.frequency.RegionMeasurement;
import haltere.filters.frequency.RegionMeter;
import haltere.ui.rendering.EventFrame;
import haltere.ui.rendering.EventPicture;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Measurements at positions of the picture: the pixel under the mouse, and a region of interest.
 * Without them it has no cost.
 *
 * <p>Thread rule: {@link #point} and {@link #setRegion} on the JavaFX thread, all else on the
 * processing thread.
 */
final class ViewProbes {
  /** Neighbours at each side of the pixel under the mouse that its rate is made of. */
  static final int NEIGHBOURS = 2;

  /** The rate near the mouse is that of the last tenth of a second. */
  private static final int NEAR_BINS = 512;

  /** How often the frequency is looked for. */
  private static final long FREQUENCY_NANOS = 250_000_000;

  private volatile Optional<PixelRegion> pointed = Optional.empty();
  private volatile Optional<PixelRegion> requestedRegion = Optional.empty();
  private RegionMeter near;
  private RegionMeter region;
  private double frequencyHz = Double.NaN;
  private long frequencyNanos;

  /** The mouse is over a pixel, or over none. */
  void point(Optional<PixelRegion> pixel) {
    pointed = pixel.map(at -> PixelRegion.around(at.left(), at.bottom(), NEIGHBOURS));
  }

  /** The region of interest, or none. */
  void setRegion(Optional<PixelRegion> newRegion) {
    requestedRegion = newRegion;
  }

  /** Time for which events affect the measurements, microseconds. */
  long memoryUs() {
    return RegionMeter.BIN_US * (long) (requestedRegion.isPresent() ? RegionMeter.BINS : NEAR_BINS);
  }

  /** Requests the next frequency at once. */
  void settle() {
    frequencyNanos = System.nanoTime() - FREQUENCY_NANOS - 1;
  }

  void packet(EventPacket packet) {
    follow();
    meters().forEach(meter -> meter.packet(packet));
  }

  void notified(StreamNotification notification) {
    meters().forEach(meter -> meter.notified(notification));
  }

  private Stream<RegionMeter> meters() {
    return Stream.of(near, region).filter(Objects::nonNull);
  }

  private void follow() {
    near = meter(near, pointed, NEAR_BINS);
    region = meter(region, requestedRegion, RegionMeter.BINS);
  }

  private static RegionMeter meter(RegionMeter old, Optional<PixelRegion> wanted, int bins) {
    if (wanted.isEmpty()) {
      return null;
    }
    return old != null && Objects.equals(old.region(), wanted.get())
        ? old
        : new RegionMeter(wanted.get(), bins);
  }

  /** Information on the pixel under the mouse. */
  Optional<PixelInfo> pixel(EventPicture events) {
    EventFrame frame = events.frame();
    follow();
    if (near == null) {
      return Optional.empty();
    }
    int x = near.region().left() + NEIGHBOURS;
    int y = near.region().bottom() + NEIGHBOURS;
    if (!frame.geometry().contains(x, y)) {
      return Optional.empty();
    }
    RegionMeasurement around = near.measure(false);
    long lastUs = frame.lastUs(x, y);
    return Optional.of(
        new PixelInfo(
            x,
            y,
            lastUs,
            frame.lastOn(x, y),
            frame.nowUs() - lastUs,
            around.spanUs() > 0 ? around.rateEps() : Double.NaN,
            events.frequencyHz(x, y)));
  }

  /** Measurement of the region of interest, with a present frequency. */
  RegionMeasurement regionNow(long nowUs) {
    settle();
    return region(nowUs).orElse(RegionMeasurement.NOTHING);
  }

  Optional<RegionMeasurement> region(long nowUs) {
    follow();
    if (region == null) {
      return Optional.empty();
    }
    region.advanceTo(nowUs);
    long nanos = System.nanoTime();
    boolean look = nanos - frequencyNanos > FREQUENCY_NANOS;
    RegionMeasurement now = region.measure(look);
    if (look) {
      frequencyNanos = nanos;
      frequencyHz = now.frequencyHz();
    }
    return Optional.of(
        new RegionMeasurement(now.rateEps(), now.onShare(), frequencyHz, now.spanUs()));
  }
}
