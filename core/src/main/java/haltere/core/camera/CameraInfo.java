package haltere.core.camera;

import haltere.core.event.SensorGeometry;
import java.util.Objects;

/**
 * A camera that was found.
 *
 * @param id permanent name, also after replugging, such as {@code dvs128:0042}
 * @param model name of the model, such as {@code DVS128}
 * @param serial serial number, empty if there is none or it cannot be read
 * @param geometry of the sensor, as far as known before opening
 * @param canOpen whether it can be opened, as far as known
 * @param note why it cannot be opened with advice, or a remark, or empty
 * @since 0.1
 */
public record CameraInfo(
    String id, String model, String serial, SensorGeometry geometry, boolean canOpen, String note) {
  /** Checks that nothing is null. */
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
