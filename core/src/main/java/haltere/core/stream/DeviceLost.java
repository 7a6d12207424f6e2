package haltere.core.stream;

import java.util.Objects;

/**
 * The camera was lost; the end of the stream follows.
 *
 * @param device the camera, in words for users
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
