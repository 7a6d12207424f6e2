package haltere.core.stream;

import haltere.core.event.SensorGeometry;
import java.util.Objects;

/**
 * The first notification of every stream.
 *
 * @param geometry the sensor that the events come from
 * @param source what a person would call the source: a file's name, a camera's, a scene's
 * @since 0.1
 */
public record StreamStarted(SensorGeometry geometry, String source) implements StreamNotification {
  /** Checks that nothing is missing. */
  public StreamStarted {
    Objects.requireNonNull(geometry, "geometry");
    Objects.requireNonNull(source, "source");
  }

  @Override
  public boolean endsContinuity() {
    return true;
  }
}
