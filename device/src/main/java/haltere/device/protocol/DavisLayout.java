package haltere.device.protocol;

import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;

/**
 * Layout of a DAVIS camera's words, as read from the camera.
 *
 * @param columns values that a column word can have, 1 to 2048
 * @param rows values that a row word can have, 1 to 2048
 * @param swapped whether column words are the sensor's rows
 * @param frameFlips for frames: bit 0 upside down, bit 1 left to right, bit 2 rows for columns
 * @param inertialFlips for inertial samples: bits 2, 1 and 0 invert x, y and z
 * @param doubleSamples whether samples of pixels use half of their range (DAVIS240)
 * @param wideThermometer whether the thermometer is that of an MPU-9250, else of an MPU-6050
 */
public record DavisLayout(
    int columns,
    int rows,
    boolean swapped,
    int frameFlips,
    int inertialFlips,
    boolean doubleSamples,
    boolean wideThermometer) {
  private static final int MAX_SIDE_PX = 2048;

  /** Checks the sizes. */
  public DavisLayout {
    if (columns < 1 || rows < 1 || columns > MAX_SIDE_PX || rows > MAX_SIDE_PX) {
      throw new IllegalArgumentException("no sensor has " + columns + "x" + rows + " pixels");
    }
  }

  /**
   * The sensor in the orientation of the image.
   *
   * @return its size
   */
  public SensorGeometry geometry() {
    return new SensorGeometry(swapped ? rows : columns, swapped ? columns : rows, Origin.TOP);
  }
}
