package haltere.ui.plot;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/**
 * Plots for the assessment of an estimate.
 *
 * @param title title for users
 * @param stage whose numbers they are
 * @param lanes the fields of each lane
 */
public record PlotSet(String title, String stage, List<List<PlotField>> lanes) {
  /**
   * The title of each set, and below it each lane as the names of its fields: outlet and column.
   */
  private static final String KNOWN =
      """
      Acceleration and rotation
        samples/acceleration_g
        samples/rotation_deg_s
      Stroke with measurements
        measurements/measured_rad wings/angle_rad
        wings/centre_rad
        wings/amplitude_rad
        wings/frequency_hz
        wings/phase_rad
      Kalman filter beside running average (method BOTH)
        wings/angle_rad averages/angle_rad
        differences/angle_rad
        wings/amplitude_rad averages/amplitude_rad
        wings/frequency_hz averages/frequency_hz
      Left beside right
        wings/angle_rad
        pairs/left_minus_right_rad pairs/left_plus_right_rad
        pairs/amplitude_left_minus_right_rad
        pairs/phase_lag_rad
      Covariance of the stroke
        variances/centre_rad2 variances/amplitude_rad2 variances/phase_rad2
        variances/centre_amplitude_rad2 variances/centre_phase_rad2 variances/amplitude_phase_rad2
        variances/frequency_rad2_per_s2
        variances/phase_frequency_rad2_per_s
        variances/nis
      Measured and estimated position
        estimates/measured_x estimates/x
        estimates/measured_y estimates/y
      Covariance and gain
        estimates/p_xx estimates/p_yy
        estimates/p_xvx estimates/p_yvy
        estimates/p_vxvx estimates/p_vyvy
        estimates/gain_x estimates/gain_y
        estimates/nis
      Measurement and process variance
        estimates/r_px2
        estimates/q_xx
        estimates/q_vxvx
      """;

  /** Default plots of a report for any publishing filter, with names as above. */
  private static final List<List<String>> MAIN =
      List.of(
          List.of(
              "wings/angle_rad",
              "wings/amplitude_rad",
              "wings/frequency_hz",
              "pairs/phase_lag_rad"),
          List.of("objects/x_px", "objects/y_px"));

  /** Copies the lists. */
  public PlotSet {
    lanes = lanes.stream().map(List::copyOf).toList();
  }

  /** The sets of which all is offered, by stage. */
  public static List<PlotSet> of(List<PlotField> offered) {
    List<PlotSet> sets = new ArrayList<>();
    for (String stage : offered.stream().map(PlotField::stage).distinct().toList()) {
      for (String known : KNOWN.split("\n(?! )")) {
        List<String> lines = known.lines().map(String::strip).toList();
        PlotSet set =
            new PlotSet(lines.get(0), stage, lanes(stage, lines.subList(1, lines.size())));
        if (set.lanes.stream().allMatch(offered::containsAll)) {
          sets.add(set);
        }
      }
    }
    return sets;
  }

  /**
   * The fields that a report plots, in the order of the stages: the main results, else the first
   * two columns of each stage.
   */
  public static List<PlotField> main(List<PlotField> offered) {
    List<PlotField> plotted = new ArrayList<>();
    for (String stage : offered.stream().map(PlotField::stage).distinct().toList()) {
      List<PlotField> fields = offered.stream().filter(each -> each.stage().equals(stage)).toList();
      plotted.addAll(
          MAIN.stream()
              .map(names -> names.stream().map(name -> field(stage, name)).toList())
              .filter(fields::containsAll)
              .findFirst()
              .orElseGet(() -> fields.stream().limit(2).toList()));
    }
    return plotted;
  }

  private static List<List<PlotField>> lanes(String stage, List<String> names) {
    return names.stream()
        .map(lane -> Stream.of(lane.split(" ")).map(name -> field(stage, name)).toList())
        .toList();
  }

  private static PlotField field(String stage, String name) {
    int slash = name.indexOf('/');
    return new PlotField(stage, name.substring(0, slash), name.substring(slash + 1));
  }
}
