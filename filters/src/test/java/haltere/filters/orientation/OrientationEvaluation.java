package haltere.filters.orientation;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Follows many simulated flights and prints the figures of docs/orientation.md: {@code ./gradlew
 * :filters:evaluateOrientation}.
 */
public final class OrientationEvaluation {
  private static final double SECONDS = 3;

  private OrientationEvaluation() {}

  /**
   * Runs.
   *
   * @param args number of flights, first seed, and settings of the filter
   */
  public static void main(String[] args) {
    int flights = Integer.parseInt(args[0]);
    long firstSeed = Long.parseLong(args[1]);
    String[] assignments = List.of(args).subList(2, args.length).toArray(new String[0]);
    OrientationSettings settings = OrientationSettings.defaults().with(assignments);
    for (int cameras : new int[] {2, 3, 4, 6}) {
      List<FlightScores> all = new ArrayList<>();
      for (long seed = firstSeed; seed < firstSeed + flights; seed++) {
        FlightScores scores = FlightScores.of(Flights.scene(cameras, seed), settings, SECONDS);
        all.add(scores);
        if (scores.wrongSigns > 0 || FlightScores.quantile(scores.lineDeg, 0.5) > 4) {
          System.out.printf(
              Locale.ROOT,
              "seed %d: %d wrong signs, median %.2f, 90%% %.2f deg%n",
              seed,
              scores.wrongSigns,
              FlightScores.quantile(scores.lineDeg, 0.5),
              FlightScores.quantile(scores.lineDeg, 0.9));
        }
      }
      print(cameras, all);
    }
  }

  private static void print(int cameras, List<FlightScores> all) {
    List<Double> line = new ArrayList<>();
    List<Double> axis = new ArrayList<>();
    List<Double> place = new ArrayList<>();
    List<Double> nees = new ArrayList<>();
    List<Double> once = new ArrayList<>();
    List<Double> nis = new ArrayList<>();
    long[] sums = new long[8];
    for (FlightScores each : all) {
      line.addAll(each.lineDeg);
      axis.addAll(each.axisDeg);
      place.addAll(each.placeMm);
      nees.addAll(each.nees);
      once.add(each.neesAtOneTime);
      nis.add(each.meanNis);
      sums[0] += each.instants;
      sums[1] += each.estimates;
      sums[2] += each.fast;
      sums[3] += each.wrongSigns;
      sums[4] += each.outliers;
      sums[5] += each.outliersRejected;
      sums[6] += each.inliers;
      sums[7] += each.inliersUsed;
    }
    System.out.printf(
        Locale.ROOT,
        "%d cameras: axis median %.2f 90%% %.2f 99%% %.2f deg, line median %.2f; place %.2f mm;"
            + " known %.4f; wrong signs %d of %d; outliers rejected %.2f %%, others used %.2f %%;"
            + " NEES mean %.2f at one time %.2f median %.2f; NIS %.3f%n",
        cameras,
        FlightScores.quantile(axis, 0.5),
        FlightScores.quantile(axis, 0.9),
        FlightScores.quantile(axis, 0.99),
        FlightScores.quantile(line, 0.5),
        FlightScores.quantile(place, 0.5),
        (double) sums[1] / sums[0],
        sums[3],
        sums[2],
        100.0 * sums[5] / sums[4],
        100.0 * sums[7] / sums[6],
        FlightScores.mean(nees),
        FlightScores.mean(once),
        FlightScores.quantile(nees, 0.5),
        FlightScores.mean(nis));
  }
}
