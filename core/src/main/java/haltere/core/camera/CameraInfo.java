package haltere.core.camera;

import haltere.core.event.SensorGeometry;
import java.util.Objects;

/**
 * A camera that was found.
 *
 * @param id names it and stays the same when it is plugged in again, such as {@code dvs128:0042}
 * @param model what a person calls the kind of camera, such as {@code DVS128}
 * @param serial its maker's number, empty if it has none or it cannot be read
 * @param geometry its sensor, as far as it is known before the camera is opened
 * @param canOpen whether nothing is known that would forbid to open it
 * @param note why it cannot be opened and what to do about it, or a remark, or empty
 * @since 0.1
 */
public record CameraInfo(
    String id, String model, String serial, SensorGeometry geometry, boolean canOpen, String note) {
  /** Checks that nothing is missing. */
  public CameraInfo {
    Objects.requireNonNull(id, "id");
    Objects.requireNonNull(model, "model");
    Objects.requireNonNull(serial, "serial");
    Objects.requireNonNull(geometry, "geometry");
    Objects.requireNonNull(note, "note");
    if (id.isBlank()) {
      throw new IllegalArgumentException("a camera has an id");
    }
  }
}
