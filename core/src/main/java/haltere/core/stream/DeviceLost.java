package haltere.core.stream;

import java.util.Objects;

/**
 * The camera went away; the end of the stream follows.
 *
 * @param device which camera, in words for a person
 * @param lastUs time of the last event that arrived, or {@link StreamNotification#NO_TIME_US}
 * @since 0.1
 */
public record DeviceLost(String device, long lastUs) implements StreamNotification {
  /** Checks that the device is named. */
  public DeviceLost {
    Objects.requireNonNull(device, "device");
  }

  @Override
  public boolean endsContinuity() {
    return false;
  }
}
