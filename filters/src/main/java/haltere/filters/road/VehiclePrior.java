package haltere.filters.road;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * What is usual on a road before anything is seen. The defaults:
 *
 * <ul>
 *   <li>speeds up to twice the 25 m/s of a rural limit of 90 km/h;
 *   <li>acceleration 0.5 m/s², the upper of the usual ones (1.5 ft/s²: Jones and Potts, Operations
 *       Research 10, 1962); braking 8 m/s², a dry road's (Greibe, Braking distance, friction and
 *       behaviour, Trafitec, 2007);
 *   <li>across the road 0.5 m/s: a lane of 3.5 m is changed in 5 to 7 s (Toledo and Zohar,
 *       Transportation Research Record 1999, 2007);
 *   <li>width at most 2.55 m (Directive 96/53/EC, Annex I) and 0.25 m of mirrors;
 *   <li>length and height between a passenger car's (5.8 × 1.3 m) and a lorry's (AASHTO, Geometric
 *       Design of Highways and Streets, 2011, Table 2-1a);
 *   <li>lower edge between the road (tyres, shadow) and the 0.2 m of ground clearance from which a
 *       car counts as an off-road vehicle (Regulation (EU) 2018/858, Annex I, A.4).
 * </ul>
 *
 * @param speedMS root mean square of the velocity along the road
 * @param accelerationMS2 usual acceleration along the road, which lasts for about a second
 * @param brakingMS2 acceleration of hard braking
 * @param driftMS usual velocity across the road
 * @param widthM greatest width of a vehicle
 * @param lengthM usual length of a vehicle
 * @param sdLengthM standard deviation of the length
 * @param heightM usual height of a vehicle
 * @param sdHeightM standard deviation of the height
 * @param lowEdgeM height above the road of the lowest edge that is seen of a vehicle
 * @param sdLowEdgeM standard deviation of this height
 */
public record VehiclePrior(
    @Help("Usual speed along the road; what is twice as fast is rare.")
        @Range(min = 1, max = 100, logarithmic = true)
        @Unit("m/s")
        double speedMS,
    @Help("Usual acceleration. A larger value follows changes sooner and smooths speeds less.")
        @Range(min = 0.01, max = 20, logarithmic = true)
        @Unit("m/s²")
        double accelerationMS2,
    @Help("Acceleration of hard braking; a larger value follows a braking vehicle sooner.")
        @Range(min = 0.01, max = 50, logarithmic = true)
        @Unit("m/s²")
        double brakingMS2,
    @Help("Usual velocity across the road, as of a change of lanes.")
        @Range(min = 0.01, max = 20, logarithmic = true)
        @Unit("m/s")
        double driftMS,
    @Help("Greatest width of a vehicle; what is wider is several.")
        @Range(min = 0.1, max = 20)
        @Unit("m")
        double widthM,
    @Help("Usual length of a vehicle.") @Range(min = 0.1, max = 50) @Unit("m") double lengthM,
    @Help("Standard deviation of the length.") @Range(min = 0.01, max = 50) @Unit("m")
        double sdLengthM,
    @Help("Usual height of a vehicle.") @Range(min = 0.1, max = 10) @Unit("m") double heightM,
    @Help("Standard deviation of the height.") @Range(min = 0.01, max = 10) @Unit("m")
        double sdHeightM,
    @Help("Height above the road of the lowest edge that is seen of a vehicle.")
        @Range(min = 0, max = 3)
        @Unit("m")
        double lowEdgeM,
    @Help("Standard deviation of the height of the lowest edge.")
        @Range(min = 0.001, max = 3, logarithmic = true)
        @Unit("m")
        double sdLowEdgeM) {
  /** Checks the ranges. */
  public VehiclePrior {
    SettingsSchema.validate(
        VehiclePrior.class,
        speedMS,
        accelerationMS2,
        brakingMS2,
        driftMS,
        widthM,
        lengthM,
        sdLengthM,
        heightM,
        sdHeightM,
        lowEdgeM,
        sdLowEdgeM);
  }

  /**
   * The settings to start from.
   *
   * @return those of a road for all vehicles
   */
  public static VehiclePrior defaults() {
    return new VehiclePrior(25, 0.5, 8, 0.5, 2.8, 5.8, 2.5, 1.6, 0.8, 0.1, 0.1);
  }
}
