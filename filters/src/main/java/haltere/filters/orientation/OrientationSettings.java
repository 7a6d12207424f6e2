package haltere.filters.orientation;

import haltere.core.settings.AdjustableSettings;
import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;
import haltere.filters.orientation.internal.axis.AxisModel;
import java.util.Map;

/**
 * Settings of {@link BodyOrientationEstimator}.
 *
 * @param gate acceptance of observations
 * @param turning process model of the axis
 * @param line measurement noise of angles
 * @param position process and measurement model of the position
 * @param direction resolution of head and tail
 */
public record OrientationSettings(
    @Help(
            "Filter of the axis: error state on the unit sphere, or quaternion as in Straw et al. (2011).")
        Form form,
    ObservationGate gate,
    Turning turning,
    AngleNoise line,
    BodyMotion position,
    HeadTail direction)
    implements AdjustableSettings<OrientationSettings> {
  /** Filter of the axis. */
  public enum Form {
    /** Error state of the axis in its tangent plane; roll is not observable and no state. */
    ERROR_STATE,
    /** Seven states, body rates and a quaternion, as in Straw et al. (2011). */
    QUATERNION
  }

  public OrientationSettings {
    SettingsSchema.validate(
        OrientationSettings.class, form, gate, turning, line, position, direction);
  }

  /**
   * {@return the default settings: the error-state filter for an insect that turns in saccades, in
   * metres, with the gate of 40 degrees of Straw et al. (2011)}
   */
  public static OrientationSettings defaults() {
    return new OrientationSettings(
        Form.ERROR_STATE,
        new ObservationGate(40, 0, 0, 0.1),
        new Turning(1, 40, 0.5, 0.3, 0.05, 0),
        new AngleNoise(2, true),
        new BodyMotion(1, 2, 5, 0.02, 0.5),
        new HeadTail(0.5, 2, 12, 50));
  }

  /**
   * The filter of Straw et al. (2011) with its defaults: quaternions, R = 10 rad², 0.1 added to
   * each variance at each update, a gate of 40° and no other. The sign of its last equation is
   * corrected, and the quaternion is normalised.
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

  static Map<String, String> formerNames() {
    return Map.of(
        "position.togetherS", "position.maxViewIntervalS",
        "position.longestGapS", "position.maxGapS",
        "direction.doubtSigmas", "direction.exchangeSigmas",
        "direction.certaintySigmas", "direction.limitSigmas");
  }

  /** The model of the axis; without outliers if the gate accepts all lines. */
  AxisModel axisModel() {
    return new AxisModel(
        turning.calmRateRadS,
        turning.saccadeRateRadS,
        turning.decayS,
        turning.saccadesPerS,
        turning.saccadeS,
        turning.updateNoise,
        Math.toRadians(gate.angleDeg),
        gate.angleDeg >= 90 ? 0 : gate.outlierShare);
  }

  /** Acceptance of observations. */
  public record ObservationGate(
      @Help(
              "Largest residual of a line; a larger value accepts more lines. 0 rejects all, 90 and"
                  + " more accept all.")
          @Range(min = 0, max = 180)
          @Unit("deg")
          double angleDeg,
      @Help("Area above which a detection is accepted; unknown areas are accepted.")
          @Range(min = 0, max = 1e9)
          @Unit("px^2")
          double minAreaPx,
      @Help(
              "Ratio of long to short axis above which a detection is accepted; unknown ratios are"
                  + " accepted.")
          @Range(min = 0, max = 1000)
          @Unit("1")
          double minEccentricity,
      @Help(
              "Expected share of outliers; a larger value rejects more lines. 0: only the largest"
                  + " residual decides.")
          @Range(min = 0, max = 0.5)
          @Unit("1")
          double outlierShare) {}

  /** Process model of the axis: rates that decay, driven by noise of calm flight or saccades. */
  public record Turning(
      @Help("Standard deviation of the angular rate about one axis in calm flight.")
          @Range(min = 0.001, max = 1000, logarithmic = true)
          @Unit("rad/s")
          double calmRateRadS,
      @Help(
              "Standard deviation of the angular rate in a saccade; equal to the calm one for a body"
                  + " without saccades.")
          @Range(min = 0.001, max = 1000, logarithmic = true)
          @Unit("rad/s")
          double saccadeRateRadS,
      @Help("Time constant of the decay of angular rates.")
          @Range(min = 0.001, max = 1000, logarithmic = true)
          @Unit("s")
          double decayS,
      @Help("Rate of saccades.") @Range(min = 0.001, max = 100, logarithmic = true) @Unit("Hz")
          double saccadesPerS,
      @Help("Mean duration of a saccade.")
          @Range(min = 0.001, max = 100, logarithmic = true)
          @Unit("s")
          double saccadeS,
      @Help(
              "Quaternions only: variance added to each of the seven states at every update,"
                  + " instead of noise of the rates (Straw et al., 2011).")
          @Range(min = 0, max = 1000)
          @Unit("1")
          double updateNoise) {}

  /** Measurement noise of angles. */
  public record AngleNoise(
      @Help("Initial standard deviation of an angle; a larger value smooths more.")
          @Range(min = 0.01, max = 1000, logarithmic = true)
          @Unit("deg")
          double angleSdDeg,
      @Help("Estimates the standard deviation of each camera from its own detections.")
          boolean calibrate) {}

  /**
   * Process and measurement model of the position, and its loss.
   *
   * @param maxViewIntervalS largest difference in time of the views that initialise a body
   */
  public record BodyMotion(
      @Help("Standard deviation of a detection's position in the picture, in each coordinate.")
          @Range(min = 0.001, max = 1000, logarithmic = true)
          @Unit("px")
          double pixelSd,
      @Help("Spectral density of the body's acceleration.")
          @Range(min = 1e-9, max = 1e9, logarithmic = true)
          @Unit("m^2/s^3")
          double accelerationDensity,
      @Help("Gate: a position is accepted within this many standard deviations of the prediction.")
          @Range(min = 1, max = 30)
          @Unit("sigma")
          double gateSigmas,
      @Help("Largest difference in time of two views that initialise a body.")
          @Range(min = 0, max = 10)
          @Unit("s")
          double maxViewIntervalS,
      @Help("A body without observations for longer than this is re-initialised.")
          @Range(min = 0.001, max = 1000, logarithmic = true)
          @Unit("s")
          double maxGapS) {}

  /** Resolution of head and tail. */
  public record HeadTail(
      @Help("Time constant of the memory of the displacement along the axis.")
          @Range(min = 0.01, max = 1000, logarithmic = true)
          @Unit("s")
          double memoryS,
      @Help(
              "Head and tail are exchanged if the backward displacement exceeds this many standard"
                  + " deviations.")
          @Range(min = 0, max = 100)
          @Unit("sigma")
          double exchangeSigmas,
      @Help("The forward displacement is limited to this many standard deviations.")
          @Range(min = 1, max = 1000)
          @Unit("sigma")
          double limitSigmas,
      @Help(
              "Standard deviation of the angle between axis and flight, for times at which cameras"
                  + " are ambiguous. 90 ignores the flight.")
          @Range(min = 5, max = 90)
          @Unit("deg")
          double slipSdDeg) {}
}
