package haltere.core.stream;

import java.util.Objects;

/**
 * Events are missing between the packet before and the packet after. Time continues.
 *
 * @param bytes raw bytes lost, or -1 if unknown
 * @param estimatedEvents events lost, or -1 without an estimate
 * @param fromUs time of the last event before the gap, or {@link StreamNotification#NO_TIME_US}
 * @param toUs time of the first event after the gap, or {@link StreamNotification#NO_TIME_US}
 * @param place where they were lost, in words for users
 * @since 0.1
 */
public record DataLost(long bytes, long estimatedEvents, long fromUs, long toUs, String place)
    implements StreamNotification {
  /** Checks that the place is named. */
  public DataLost {
    Objects.requireNonNull(place, "place");
  }

  @Override
  public boolean endsContinuity() {
    return true;
  }

  @Override
  public boolean restartsTime() {
    return false;
  }
}
