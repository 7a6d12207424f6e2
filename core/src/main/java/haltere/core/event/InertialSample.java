package haltere.core.event;

/**
 * A measurement of the inertial sensor of a camera. The axes are those of the recording.
 * Acceleration is in standard gravities and rotation in degrees per second, as in all formats.
 * Missing values are NaN.
 *
 * @param timeUs microseconds on the source's clock
 * @param accelerationXG acceleration along x, in standard gravities (9.80665 m/s²)
 * @param accelerationYG acceleration along y, in standard gravities
 * @param accelerationZG acceleration along z, in standard gravities
 * @param rotationXDegS rate of rotation about x, in degrees per second
 * @param rotationYDegS rate of rotation about y, in degrees per second
 * @param rotationZDegS rate of rotation about z, in degrees per second
 * @param temperatureC of the sensor, in degrees Celsius
 * @param magneticXMicrotesla magnetic field along x, in microteslas
 * @param magneticYMicrotesla magnetic field along y, in microteslas
 * @param magneticZMicrotesla magnetic field along z, in microteslas
 * @since 0.1
 */
public record InertialSample(
    long timeUs,
    float accelerationXG,
    float accelerationYG,
    float accelerationZG,
    float rotationXDegS,
    float rotationYDegS,
    float rotationZDegS,
    float temperatureC,
    float magneticXMicrotesla,
    float magneticYMicrotesla,
    float magneticZMicrotesla)
    implements SensorSample {
  /**
   * A sample of a sensor without a compass.
   *
   * @param timeUs microseconds on the source's clock
   * @param accelerationXG acceleration along x, in standard gravities
   * @param accelerationYG acceleration along y, in standard gravities
   * @param accelerationZG acceleration along z, in standard gravities
   * @param rotationXDegS rate of rotation about x, in degrees per second
   * @param rotationYDegS rate of rotation about y, in degrees per second
   * @param rotationZDegS rate of rotation about z, in degrees per second
   * @param temperatureC of the sensor, in degrees Celsius
   */
  public InertialSample(
      long timeUs,
      float accelerationXG,
      float accelerationYG,
      float accelerationZG,
      float rotationXDegS,
      float rotationYDegS,
      float rotationZDegS,
      float temperatureC) {
    this(
        timeUs,
        accelerationXG,
        accelerationYG,
        accelerationZG,
        rotationXDegS,
        rotationYDegS,
        rotationZDegS,
        temperatureC,
        Float.NaN,
        Float.NaN,
        Float.NaN);
  }

  @Override
  public SampleKind kind() {
    return SampleKind.INERTIAL_SAMPLE;
  }
}
