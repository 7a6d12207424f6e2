package haltere.filters.orientation;

import haltere.core.settings.Help;
import haltere.core.settings.SettingsSchema;
import java.util.List;

/**
 * Settings of {@link BodyOrientationEstimator}.
 *
 * @param form which filter follows the axis
 * @param gate which observations are used
 * @param turning how the axis turns
 * @param line how sure an observed angle is
 * @param position how the body moves
 * @param direction how head and tail are told apart
 */
public record OrientationSettings(
    @Help("The filter of the axis: on the sphere of directions, or on quaternions as the source.")
        Form form,
    ObservationGateSettings gate,
    TurningSettings turning,
    LineNoiseSettings line,
    BodyPositionSettings position,
    DirectionSettings direction) {
  /** Which filter follows the axis. */
  public enum Form {
    /** The error of the axis in its tangent plane; roll, which nobody sees, is left out. */
    ERROR_STATE,
    /** Body rates and a quaternion, seven numbers, as the source. */
    QUATERNION
  }

  /** Checks the parts. */
  public OrientationSettings {
    SettingsSchema.validate(
        OrientationSettings.class, form, gate, turning, line, position, direction);
  }

  /**
   * The settings to start from.
   *
   * @return the error-state filter for an insect that turns in saccades
   */
  public static OrientationSettings defaults() {
    return new OrientationSettings(
        Form.ERROR_STATE,
        ObservationGateSettings.defaults(),
        TurningSettings.defaults(),
        LineNoiseSettings.defaults(),
        BodyPositionSettings.defaults(),
        DirectionSettings.defaults());
  }

  /**
   * The source's filter with its defaults: quaternions, R = 10 rad², 0.1 added to each variance at
   * each update, a gate of 40° and no other. The sign of its last equation is mended, and the
   * quaternion kept at length 1.
   *
   * @return for comparison
   */
  public static OrientationSettings original() {
    return defaults()
        .with(
            "form=quaternion",
            "gate.outlierShare=0",
            "turning.decayS=0.1",
            "turning.updateNoise=0.1",
            "line.angleSdDeg=" + Math.toDegrees(Math.sqrt(10)),
            "line.calibrate=false");
  }

  /**
   * These settings but for some.
   *
   * @param assignments texts of the form {@code name=value}, such as {@code gate.angleDeg=30}
   * @return new settings
   * @throws haltere.core.settings.SettingsProblem for a name or a value that is not valid
   */
  public OrientationSettings with(String... assignments) {
    return SettingsSchema.of(OrientationSettings.class).withAssignments(this, List.of(assignments));
  }
}
