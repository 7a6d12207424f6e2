package haltere.filters.road;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/** The lanes of a road, side by side, all of one width. */
public record LaneSettings(
    @Help("Number of lanes of both directions together, 0 for none.")
        @Range(min = 0, max = 20)
        @Unit("lanes")
        int lanes,
    @Help("Left edge of the leftmost lane; negative to the left of the vanishing point.")
        @Range(min = -1000, max = 1000)
        @Unit("m")
        double leftEdgeM,
    @Help("Width of a lane.") @Range(min = 0.5, max = 20) @Unit("m") double widthM) {
  /** Number for a position beside all lanes. */
  public static final int BESIDE = -1;

  /** Checks the ranges. */
  public LaneSettings {
    SettingsSchema.validate(LaneSettings.class, lanes, leftEdgeM, widthM);
  }

  /**
   * {@return the default settings: no lanes; with a number of 4, two of 3.5 m on either side of the
   * vanishing point}
   */
  public static LaneSettings defaults() {
    return new LaneSettings(0, -7, 3.5);
  }

  /**
   * {@return lane of a position, from 0 for the leftmost, or {@link #BESIDE}}
   *
   * @param xM metres to the right, as in {@link haltere.filters.plane.RoadMapping}
   */
  public int laneAt(double xM) {
    double lane = Math.floor((xM - leftEdgeM) / widthM);
    return lane >= 0 && lane < lanes ? (int) lane : BESIDE;
  }
}
