package haltere.filters.orientation;

import haltere.core.simulation.internal.flight.FlightScene;
import haltere.filters.orientation.camera.LineObservation;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Follows many simulated flights and prints the figures of docs/orientation.md: {@code ./gradlew
 * :filters:evaluateOrientation}.
 */
public final class OrientationEvaluation {
  private static final double SECONDS = 3;

  /** The last one is told, when everything is compiled. */
  private static final int SPEED_ROUNDS = 60;

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
        all.add(FlightScores.of(Flights.scene(cameras, seed), settings, SECONDS));
      }
      print(cameras, all);
    }
    System.out.println(
        "events of two cameras: " + fromEvents(Math.max(1, flights / 20), firstSeed));
    speed();
  }

  /** Error of the axis from two event cameras. */
  private static String fromEvents(int flights, long firstSeed) {
    List<Double> errors = new ArrayList<>();
    for (long seed = firstSeed; seed < firstSeed + flights; seed++) {
      errors.addAll(EventFlights.errorsDeg(2, seed, 2));
    }
    return String.format(
        Locale.ROOT,
        "%d flights, %d estimates, axis median %.2f 90%% %.2f deg",
        flights,
        errors.size(),
        FlightScores.quantile(errors, 0.5),
        FlightScores.quantile(errors, 0.9));
  }

  /** Observations a second, of three cameras. */
  private static void speed() {
    FlightScene scene = Flights.scene(3, 1);
    int instants = 3000;
    List<List<LineObservation>> seen = new ArrayList<>();
    long observations = 0;
    for (long k = 0; k < instants; k++) {
      seen.add(Flights.observations(scene, scene.detections(k)));
      observations += seen.get((int) k).size();
    }
    for (int round = 0; round < SPEED_ROUNDS; round++) {
      BodyOrientationEstimator body =
          new BodyOrientationEstimator(Flights.cameras(scene), OrientationSettings.defaults());
      long start = System.nanoTime();
      for (int k = 0; k < instants; k++) {
        body.update(scene.pictureTimeUs(k), seen.get(k));
      }
      double seconds = (System.nanoTime() - start) * 1e-9;
      if (round == SPEED_ROUNDS - 1) {
        System.out.printf(Locale.ROOT, "%.0f observations a second%n", observations / seconds);
      }
    }
  }

  private static void print(int cameras, List<FlightScores> all) {
    List<Double> line = new ArrayList<>();
    List<Double> axis = new ArrayList<>();
    List<Double> position = new ArrayList<>();
    List<Double> nees = new ArrayList<>();
    List<Double> once = new ArrayList<>();
    List<Double> nis = new ArrayList<>();
    long[] sums = new long[9];
    for (FlightScores each : all) {
      line.addAll(each.lineDeg);
      axis.addAll(each.axisDeg);
      position.addAll(each.placeMm);
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
      sums[8] += each.lost;
    }
    System.out.printf(
        Locale.ROOT,
        "%d cameras: axis median %.2f 90%% %.2f 99%% %.2f deg, line median %.2f; place %.2f mm;"
            + " known %.4f; wrong signs %d of %d, lost %d; outliers rejected %.2f %%, others used"
            + " %.2f %%; NEES mean %.2f at one time %.2f median %.2f; NIS %.3f%n",
        cameras,
        FlightScores.quantile(axis, 0.5),
        FlightScores.quantile(axis, 0.9),
        FlightScores.quantile(axis, 0.99),
        FlightScores.quantile(line, 0.5),
        FlightScores.quantile(position, 0.5),
        (double) sums[1] / sums[0],
        sums[3],
        sums[2],
        sums[8],
        100.0 * sums[5] / sums[4],
        100.0 * sums[7] / sums[6],
        FlightScores.mean(nees),
        FlightScores.mean(once),
        FlightScores.quantile(nees, 0.5),
        FlightScores.mean(nis));
  }
}
