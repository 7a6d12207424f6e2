package haltere.core.stream;

import haltere.core.event.SensorGeometry;
import java.util.Objects;

/**
 * The first notification of every stream.
 *
 * @param geometry the sensor that the events come from
 * @param source name for users: of a file, camera or scene
 * @since 0.1
 */
public record StreamStarted(SensorGeometry geometry, String source) implements StreamNotification {
  /** Checks that nothing is null. */
  public StreamStarted {
    Objects.requireNonNull(geometry, "geometry");
    Objects.requireNonNull(source, "source");
  }

  @Override
  public boolean endsContinuity() {
    return true;
  }
}
