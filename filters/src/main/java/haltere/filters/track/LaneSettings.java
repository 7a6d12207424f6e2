package haltere.filters.track;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * The lanes of a road, side by side, all of one width.
 *
 * @param lanes how many there are
 * @param leftEdgeM where the leftmost one begins
 * @param widthM width of each
 */
public record LaneSettings(
    @Help("Number of lanes of both directions together, 0 for none.")
        @Range(min = 0, max = 20)
        @Unit("lanes")
        int lanes,
    @Help("Left edge of the leftmost lane, to the right of the plane of the vanishing point.")
        @Range(min = -1000, max = 1000)
        @Unit("m")
        double leftEdgeM,
    @Help("Width of a lane.") @Range(min = 0.5, max = 20) @Unit("m") double widthM) {
  /** Beside all lanes. */
  public static final int BESIDE = -1;

  /** Checks the ranges. */
  public LaneSettings {
    SettingsSchema.validate(LaneSettings.class, lanes, leftEdgeM, widthM);
  }

  /**
   * The settings to start from.
   *
   * @return no lanes; two each way of 3.5 m once their number is set to 4
   */
  public static LaneSettings defaults() {
    return new LaneSettings(0, -7, 3.5);
  }

  /**
   * Where the rightmost lane ends.
   *
   * @return metres to the right; the left edge if there are no lanes
   */
  public double rightEdgeM() {
    return leftEdgeM + lanes * widthM;
  }

  /**
   * The lane that a place is in.
   *
   * @param lateralM metres to the right
   * @return from 0 for the leftmost, or {@link #BESIDE}
   */
  public int laneAt(double lateralM) {
    double lane = number(lateralM);
    return lane >= 0 && lane < lanes ? (int) lane : BESIDE;
  }

  /**
   * The middle of the lane that a place is in, or of the nearest one where it is beside them all.
   *
   * @param lateralM metres to the right
   * @return metres to the right; of no use if there are no lanes
   */
  public double nearestMiddleM(double lateralM) {
    double lane = Math.max(0, Math.min(lanes - 1, number(lateralM)));
    return leftEdgeM + (lane + 0.5) * widthM;
  }

  /** Number of the lane at a place if lanes went on to both sides. */
  private double number(double lateralM) {
    return Math.floor((lateralM - leftEdgeM) / widthM);
  }
}
