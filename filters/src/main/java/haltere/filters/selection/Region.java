package haltere.filters.selection;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import java.util.Objects;

/**
 * Passes the events inside, or those outside, of a rectangle of pixels.
 *
 * <p>Thread rule: not safe for use by two threads at a time.
 *
 * @since 0.1
 */
public final class Region {
  private RegionSettings settings;

  /**
   * A filter.
   *
   * @param settings of the filter
   */
  public Region(RegionSettings settings) {
    apply(settings);
  }

  /**
   * The settings.
   *
   * @return the settings in force
   */
  public RegionSettings settings() {
    return settings;
  }

  /**
   * Applies settings from the next packet on.
   *
   * @param newSettings the settings to use
   */
  public void apply(RegionSettings newSettings) {
    settings = Objects.requireNonNull(newSettings, "newSettings");
  }

  /**
   * Removes the events on the other side.
   *
   * @param packet filtered in place
   */
  public void filter(EventPacket packet) {
    int left = settings.leftPx();
    int bottom = settings.bottomPx();
    int right = left + settings.widthPx();
    int top = bottom + settings.heightPx();
    int inside = settings.keep() == RegionSettings.RegionSide.INSIDE ? 1 : 0;
    int passed = 0;
    for (int i = 0; i < packet.size(); i++) {
      int address = packet.address(i);
      int x = EventAddress.x(address);
      int y = EventAddress.y(address);
      packet.move(i, passed);
      // None of the four differences is negative inside: their ORed sign bit is 1 outside.
      int outside = (x - left | right - 1 - x | y - bottom | top - 1 - y) >>> 31;
      passed += outside ^ inside;
    }
    packet.truncate(passed);
  }
}
