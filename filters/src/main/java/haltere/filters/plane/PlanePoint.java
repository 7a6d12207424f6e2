package haltere.filters.plane;

import haltere.core.sink.Column;
import haltere.filters.estimation.GaussianState;

/**
 * Position and velocity of an object on a plane at one time, from events before that time only. On
 * a road x is across it to the right and y along it away from the camera, see {@link RoadMapping}.
 *
 * @param timeUs time on the clock of the events, microseconds
 * @param id identity of the track
 * @param xM first coordinate, metres
 * @param yM second coordinate, metres
 * @param vxMS first velocity, metres a second
 * @param vyMS second velocity, metres a second; on a road negative towards the camera
 * @param sdXM standard deviation of the first coordinate, metres
 * @param sdYM standard deviation of the second coordinate, metres
 * @param sdVxMS standard deviation of the first velocity, metres a second
 * @param sdVyMS standard deviation of the second velocity, metres a second
 */
public record PlanePoint(
    @Column("t_us") long timeUs,
    int id,
    @Column(decimals = 4) double xM,
    @Column(decimals = 4) double yM,
    @Column(value = "vx_m_s", decimals = 4) double vxMS,
    @Column(value = "vy_m_s", decimals = 4) double vyMS,
    @Column(value = "sd_x_m", decimals = 4) double sdXM,
    @Column(value = "sd_y_m", decimals = 4) double sdYM,
    @Column(value = "sd_vx_m_s", decimals = 4) double sdVxMS,
    @Column(value = "sd_vy_m_s", decimals = 4) double sdVyMS) {
  private static final double KM_H_PER_M_S = 3.6;

  /**
   * {@return the point of a belief, with its standard deviations}
   *
   * @param timeUs time, microseconds
   * @param id identity of the track
   * @param state x, its velocity, y and its velocity are the first four entries
   */
  public static PlanePoint of(long timeUs, int id, GaussianState state) {
    return new PlanePoint(
        timeUs,
        id,
        state.mean(0),
        state.mean(2),
        state.mean(1),
        state.mean(3),
        state.sd(0),
        state.sd(2),
        state.sd(1),
        state.sd(3));
  }

  /** {@return speed on the plane, kilometres an hour} */
  public double speedKmH() {
    return KM_H_PER_M_S * Math.hypot(vxMS, vyMS);
  }

  /**
   * {@return the standard deviation of the speed, to first order and with uncorrelated velocities,
   * kilometres an hour; that of a point at rest is the larger one of its velocities}
   */
  public double sdSpeedKmH() {
    double speed = Math.hypot(vxMS, vyMS);
    return KM_H_PER_M_S
        * (speed == 0
            ? Math.max(sdVxMS, sdVyMS)
            : Math.hypot(vxMS * sdVxMS, vyMS * sdVyMS) / speed);
  }
}
