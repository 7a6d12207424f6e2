package haltere.filters.orientation;

import haltere.core.settings.AdjustableSettings;
import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * Settings of {@link BodyOrientationEstimator}.
 *
 * @param gate which observations are used
 * @param turning how the axis turns
 * @param line noise of observed angles
 * @param position how the body moves
 * @param direction how head and tail are resolved
 */
public record OrientationSettings(
    @Help(
            "The filter of the axis: on the sphere of directions, or on quaternions, as Straw et al. (2011).")
        Form form,
    ObservationGate gate,
    Turning turning,
    AngleNoise line,
    BodyMotion position,
    HeadTail direction)
    implements AdjustableSettings<OrientationSettings> {
  /** Which filter follows the axis. */
  public enum Form {
    /** The error of the axis in its tangent plane; roll, which nobody sees, is left out. */
    ERROR_STATE,
    /** Body rates and a quaternion, seven numbers, as Straw et al. (2011). */
    QUATERNION
  }

  public OrientationSettings {
    SettingsSchema.validate(
        OrientationSettings.class, form, gate, turning, line, position, direction);
  }

  /**
   * {@return the settings to start from: the error-state filter for an insect that turns in
   * saccades, in metres, with the gate of 40 degrees of Straw et al. (2011)}
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
   * mended, and the quaternion kept at length 1.
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

  /** Which observations are used. */
  public record ObservationGate(
      @Help(
              "Largest angle between an observed line and the expected one; a larger value accepts"
                  + " more. 0 rejects all, 90 and more accept all.")
          @Range(min = 0, max = 180)
          @Unit("deg")
          double angleDeg,
      @Help("A detection must be larger than this; one of unknown area is.")
          @Range(min = 0, max = 1e9)
          @Unit("px^2")
          double minAreaPx,
      @Help(
              "A detection's long axis must be more than this times its short one; one of unknown"
                  + " ratio is.")
          @Range(min = 0, max = 1000)
          @Unit("1")
          double minEccentricity,
      @Help(
              "Share of lines that are outliers; a larger value rejects more lines. 0 leaves the"
                  + " decision to the angle.")
          @Range(min = 0, max = 0.5)
          @Unit("1")
          double outlierShare) {
    /** The outlier share, 0 where the angle accepts all. */
    double effectiveOutlierShare() {
      return angleDeg >= 90 ? 0 : outlierShare;
    }
  }

  /** How the axis turns: at rates that decay and are driven by noise, calmly or in saccades. */
  public record Turning(
      @Help("Standard deviation of the rate of turning about one axis, in calm flight.")
          @Range(min = 0.001, max = 1000, logarithmic = true)
          @Unit("rad/s")
          double calmRateRadS,
      @Help(
              "Standard deviation of the rate in a saccade; as large as the calm one for a body that"
                  + " makes none.")
          @Range(min = 0.001, max = 1000, logarithmic = true)
          @Unit("rad/s")
          double saccadeRateRadS,
      @Help("Time constant with which rates decay.")
          @Range(min = 0.001, max = 1000, logarithmic = true)
          @Unit("s")
          double decayS,
      @Help("How often a saccade begins.")
          @Range(min = 0.001, max = 100, logarithmic = true)
          @Unit("Hz")
          double saccadesPerS,
      @Help("How long a saccade lasts on average.")
          @Range(min = 0.001, max = 100, logarithmic = true)
          @Unit("s")
          double saccadeS,
      @Help(
              "Quaternions only: variance added to each of the seven states at every update,"
                  + " instead of the noise of the rates (Straw et al., 2011).")
          @Range(min = 0, max = 1000)
          @Unit("1")
          double updateNoise) {
    /** Share of the time that is spent in saccades. */
    double saccadeShare() {
      return saccadesPerS * saccadeS / (1 + saccadesPerS * saccadeS);
    }

    /** Variance of a rate, over calm flight and saccades. */
    double meanRateVariance() {
      double share = saccadeShare();
      return (1 - share) * calmRateRadS * calmRateRadS + share * saccadeRateRadS * saccadeRateRadS;
    }
  }

  /** Noise of observed angles. */
  public record AngleNoise(
      @Help("Initial standard deviation of an observed angle; a larger value trusts lines less.")
          @Range(min = 0.01, max = 1000, logarithmic = true)
          @Unit("deg")
          double angleSdDeg,
      @Help("Whether the standard deviation of each camera is learnt from its own detections.")
          boolean calibrate) {}

  /**
   * How the body moves, and when it is lost.
   *
   * @param togetherS how far apart in time cameras may look and still be taken together at the
   *     start
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
      @Help("A position is used if it is within so many standard deviations of the expected one.")
          @Range(min = 1, max = 30)
          @Unit("sigma")
          double gateSigmas,
      @Help("Views of two cameras that are no further apart in time may start a body.")
          @Range(min = 0, max = 10)
          @Unit("s")
          double togetherS,
      @Help("A body that was not seen for longer is re-initialised.")
          @Range(min = 0.001, max = 1000, logarithmic = true)
          @Unit("s")
          double longestGapS) {}

  /** How head and tail are resolved. */
  public record HeadTail(
      @Help("Time constant with which the way that the body has flown along its axis is forgotten.")
          @Range(min = 0.01, max = 1000, logarithmic = true)
          @Unit("s")
          double memoryS,
      @Help(
              "Head and tail are exchanged when the way flown backwards is so many times its standard"
                  + " deviation.")
          @Range(min = 0, max = 100)
          @Unit("sigma")
          double doubtSigmas,
      @Help("The way flown forwards counts up to so many times its standard deviation.")
          @Range(min = 1, max = 1000)
          @Unit("sigma")
          double certaintySigmas,
      @Help(
              "Standard deviation of the angle between axis and flight, for moments without an"
                  + " axis from the cameras. 90 leaves the flight out.")
          @Range(min = 5, max = 90)
          @Unit("deg")
          double slipSdDeg) {}
}
