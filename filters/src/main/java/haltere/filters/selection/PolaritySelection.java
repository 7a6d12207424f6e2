package haltere.filters.selection;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import java.util.Objects;

/**
 * Passes the events of one polarity, or of both.
 *
 * <p>Thread rule: not safe for use by two threads at a time.
 *
 * @since 0.1
 */
public final class PolaritySelection {
  private PolaritySettings settings;

  /**
   * A filter.
   *
   * @param settings of the filter
   */
  public PolaritySelection(PolaritySettings settings) {
    apply(settings);
  }

  /**
   * The settings.
   *
   * @return the settings in force
   */
  public PolaritySettings settings() {
    return settings;
  }

  /**
   * Applies settings from the next packet on.
   *
   * @param newSettings the settings to use
   */
  public void apply(PolaritySettings newSettings) {
    settings = Objects.requireNonNull(newSettings, "newSettings");
  }

  /**
   * Removes the events of the other polarity.
   *
   * @param packet filtered in place
   */
  public void filter(EventPacket packet) {
    if (settings.keep() == PolaritySettings.Keep.BOTH) {
      return;
    }
    int other = settings.keep() == PolaritySettings.Keep.ON ? 0 : 1;
    int passed = 0;
    for (int i = 0; i < packet.size(); i++) {
      int onBit = packet.address(i) & EventAddress.ON_BIT;
      packet.move(i, passed);
      passed += onBit ^ other;
    }
    packet.truncate(passed);
  }
}
