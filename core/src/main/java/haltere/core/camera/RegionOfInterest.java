package haltere.core.camera;

import java.util.Optional;

/**
 * A camera that can restrict its readout to a region of its sensor.
 *
 * <p>Thread rule: all methods may be called from any thread.
 *
 * @since 0.1
 */
public interface RegionOfInterest {
  /**
   * A part of the sensor.
   *
   * @param left its first column
   * @param bottom its first row, counted upwards
   * @param width columns, at least 1
   * @param height rows, at least 1
   */
  record Region(int left, int bottom, int width, int height) {
    /** Checks that it has a pixel. */
    public Region {
      if (left < 0 || bottom < 0 || width < 1 || height < 1) {
        throw new IllegalArgumentException(
            "no region: " + width + "x" + height + " at (" + left + ", " + bottom + ")");
      }
    }
  }

  /**
   * The region that is read out.
   *
   * @return empty for the whole sensor
   */
  Optional<Region> region();

  /**
   * Sets the region that is read out.
   *
   * @param region on the sensor, or empty for all of it
   * @throws IllegalArgumentException if it is not on the sensor
   * @throws CameraProblem if the camera refuses or is gone
   */
  void setRegion(Optional<Region> region) throws CameraProblem;
}
