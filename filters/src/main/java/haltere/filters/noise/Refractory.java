package haltere.filters.noise;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import java.util.Arrays;
import java.util.Objects;

/**
 * Passes an event if its pixel has been silent for longer than a refractory period before it. The
 * first event of a pixel passes.
 *
 * <p>Thread rule: not safe for use by two threads at a time.
 *
 * @since 0.1
 */
public final class Refractory {
  /** Initial time, whose difference to any time within 2<sup>62</sup> us of 0 does not overflow. */
  private static final long NEVER_US = Long.MIN_VALUE / 2;

  private final int width;
  private final long[] lastUs;
  private RefractorySettings settings;

  /**
   * A filter in its initial state.
   *
   * @param geometry of the sensor
   * @param settings of the filter
   */
  public Refractory(SensorGeometry geometry, RefractorySettings settings) {
    this.settings = Objects.requireNonNull(settings, "settings");
    width = geometry.width();
    lastUs = new long[geometry.pixels()];
    reset();
  }

  /** Removes all events. */
  public void reset() {
    Arrays.fill(lastUs, NEVER_US);
  }

  /**
   * The settings.
   *
   * @return the settings in force
   */
  public RefractorySettings settings() {
    return settings;
  }

  /**
   * Applies settings from the next packet on; the state stays.
   *
   * @param newSettings the settings to use
   */
  public void apply(RefractorySettings newSettings) {
    settings = Objects.requireNonNull(newSettings, "newSettings");
  }

  /**
   * Removes the events within the refractory period.
   *
   * @param packet filtered in place
   */
  public void filter(EventPacket packet) {
    long periodUs = settings.periodUs();
    int always = settings.silence() == RefractorySettings.Silence.SINCE_LAST_SEEN ? 1 : 0;
    int passed = 0;
    for (int i = 0; i < packet.size(); i++) {
      int address = packet.address(i);
      int pixel = EventAddress.y(address) * width + EventAddress.x(address);
      long before = lastUs[pixel];
      long silenceUs = packet.timeUs(i) - before;
      // sign bits instead of unpredictable branches: 1 if the event passes
      int passes = (int) (periodUs - silenceUs >>> 63);
      // the event's own time if it counts, else the previous time
      lastUs[pixel] = before + (silenceUs & -(long) (passes | always));
      // moved in any case: the next event overwrites it unless it passes
      packet.move(i, passed);
      passed += passes;
    }
    packet.truncate(passed);
  }
}
