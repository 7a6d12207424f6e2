package haltere.core.camera;

/**
 * One moment on two clocks, the camera's and this computer's. Its error is the shortest recent
 * delay of events, so that two cameras on one computer agree to about a millisecond.
 *
 * @param cameraUs the moment on the camera's clock, microseconds
 * @param hostNanos the moment by {@link System#nanoTime}, or a little after it
 * @since 0.1
 */
public record ClockRelation(long cameraUs, long hostNanos) {
  private static final long NANOS_PER_US = 1000;

  /**
   * A time of the camera on the computer's clock.
   *
   * @param timeUs microseconds on the camera's clock
   * @return on the clock of {@link System#nanoTime}
   */
  public long hostNanos(long timeUs) {
    return hostNanos + (timeUs - cameraUs) * NANOS_PER_US;
  }

  /**
   * A time of this camera on the clock of another.
   *
   * @param timeUs microseconds on this camera's clock
   * @param other the other camera's relation to the same computer
   * @return microseconds on the other camera's clock
   */
  public long onClockOf(ClockRelation other, long timeUs) {
    return other.cameraUs + Math.floorDiv(hostNanos(timeUs) - other.hostNanos, NANOS_PER_US);
  }
}
