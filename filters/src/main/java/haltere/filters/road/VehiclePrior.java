package haltere.filters.road;

import haltere.core.settings.Help;
import haltere.core.settings.Range;
import haltere.core.settings.SettingsSchema;
import haltere.core.settings.Unit;

/**
 * Prior of vehicles on a road. Defaults, with their sources:
 *
 * <ul>
 *   <li>speed: a rural limit of 90 km/h;
 *   <li>acceleration (assumed): speeds change by 2 km/h within a second;
 *   <li>braking (assumed): 0.8 times gravity, more than the 0.7 of sliding wheels;
 *   <li>drift: a lane of 3.5 m in 5 to 6 s (Toledo and Zohar, Modeling Duration of Lane Changes,
 *       Transportation Research Record, 2007), reduced since most vehicles stay in their lane;
 *   <li>width: 2.55 m (Directive 96/53/EC, Annex I), and mirrors (assumed);
 *   <li>length, height: between a passenger car, 5.8 × 1.3 m, and a lorry, 9.2 × 3.4 to 4.1 m
 *       (AASHTO, Geometric Design of Highways and Streets, 2004, Exhibit 2-1);
 *   <li>lower edge: between the road (tyres, shadow) and the 0.2 m of clearance between axles of an
 *       off-road vehicle (category M1G: Regulation (EU) 2018/858, Annex I, Part A).
 * </ul>
 *
 * @param lowEdgeM usual height above the road of the lowest visible edge, and its standard
 *     deviation
 */
public record VehiclePrior(
    @Help("Usual speed along the road; twice this speed is rare.")
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
    @Help("Usual velocity across the road, such as in a change of lanes.")
        @Range(min = 0.01, max = 20, logarithmic = true)
        @Unit("m/s")
        double driftMS,
    @Help("Greatest width of a vehicle; a wider object is several vehicles.")
        @Range(min = 0.1, max = 20)
        @Unit("m")
        double widthM,
    @Help("Usual length of a vehicle.") @Range(min = 0.1, max = 50) @Unit("m") double lengthM,
    @Help("Usual height of a vehicle.") @Range(min = 0.1, max = 10) @Unit("m") double heightM,
    @Help("Usual height above the road of a vehicle's lowest visible edge.")
        @Range(min = 0.001, max = 3)
        @Unit("m")
        double lowEdgeM) {
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
        heightM,
        lowEdgeM);
  }

  /** {@return the default settings: those of a road for all vehicles} */
  public static VehiclePrior defaults() {
    return new VehiclePrior(25, 0.5, 8, 0.5, 2.8, 5.8, 1.6, 0.1);
  }
}
