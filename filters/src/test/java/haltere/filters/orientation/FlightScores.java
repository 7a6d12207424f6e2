package haltere.filters.orientation;

import haltere.core.simulation.internal.flight.FlightDetection;
import haltere.core.simulation.internal.flight.FlightScene;
import haltere.core.simulation.internal.flight.FlightTruth;
import haltere.filters.orientation.camera.LineObservation;
import haltere.filters.orientation.camera.Vectors;
import haltere.filters.orientation.internal.axis.AxisState;
import haltere.filters.orientation.internal.axis.SphereFilter;
import haltere.filters.orientation.internal.axis.SpherePath;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** Scores of an estimated flight, from 0.2 s on, as the targets state. */
public final class FlightScores {
  private static final double START_S = 0.2;

  final List<Double> axisDeg = new ArrayList<>();
  final List<Double> lineDeg = new ArrayList<>();
  final List<Double> placeMm = new ArrayList<>();
  final List<Double> nees = new ArrayList<>();
  double neesAtOneTime = Double.NaN;
  double meanNis;
  long instants;
  long estimates;
  long fast;

  /** Instants at which the axis was nearer to the tail than to the head. */
  long wrongSigns;

  /** Instants at which the line itself was off by more than 45 degrees. */
  long lost;

  long outliers;
  long outliersRejected;
  long inliers;
  long inliersUsed;
  double worstLength;

  /** Largest standard deviation of the axis that was told. */
  double widestRad;

  /** Follows a flight online. */
  static FlightScores of(FlightScene scene, OrientationSettings settings, double seconds) {
    FlightScores scores = new FlightScores();
    double bodyLengthsAtFast = 5;
    BodyOrientationEstimator body = new BodyOrientationEstimator(Flights.cameras(scene), settings);
    double lengthM = 0.012;
    boolean[] outlier = new boolean[scene.cameras().size()];
    long oneTime = 0;
    for (long k = 0; (scene.pictureTimeUs(k) - scene.startUs()) * 1e-6 < seconds; k++) {
      long timeUs = scene.pictureTimeUs(k);
      List<FlightDetection> seen = scene.detections(k, outlier);
      List<LineObservation> lines = Flights.observations(scene, seen);
      Optional<OrientationEstimate> now = body.update(timeUs, lines);
      FlightTruth truth = scene.truthAt(timeUs);
      double elapsed = (timeUs - scene.startUs()) * 1e-6;
      if (elapsed < START_S) {
        continue;
      }
      scores.instants++;
      if (now.isEmpty()) {
        continue;
      }
      boolean isFast =
          Math.sqrt(
                  truth.vxMS() * truth.vxMS()
                      + truth.vyMS() * truth.vyMS()
                      + truth.vzMS() * truth.vzMS())
              > bodyLengthsAtFast * lengthM;
      scores.note(now.get(), truth, isFast);
      for (LineObservation line : lines) {
        boolean used = body.used(line.camera());
        if (outlier[line.camera()]) {
          scores.outliers++;
          scores.outliersRejected += used ? 0 : 1;
        } else {
          scores.inliers++;
          scores.inliersUsed += used ? 1 : 0;
        }
      }
      if (body.axis instanceof SphereFilter filter) {
        double value = nees(SpherePath.state(filter), truth);
        scores.nees.add(value);
        oneTime++;
        if (oneTime == (long) (seconds * 40)) {
          scores.neesAtOneTime = value;
        }
      }
    }
    scores.meanNis = body.meanNis();
    return scores;
  }

  void note(OrientationEstimate now, FlightTruth truth, boolean isFast) {
    double[] u = {now.ux(), now.uy(), now.uz()};
    double[] t = {truth.ux(), truth.uy(), truth.uz()};
    double off = Math.toDegrees(Vectors.angle(u, t));
    estimates++;
    axisDeg.add(off);
    lineDeg.add(Math.min(off, 180 - off));
    placeMm.add(
        1000
            * Math.sqrt(
                Math.pow(now.xM() - truth.xM(), 2)
                    + Math.pow(now.yM() - truth.yM(), 2)
                    + Math.pow(now.zM() - truth.zM(), 2)));
    widestRad = Math.max(widestRad, now.sdAxisRad());
    worstLength = Math.max(worstLength, Math.abs(Vectors.length(u) - 1));
    if (isFast) {
      fast++;
      wrongSigns += off > 90 ? 1 : 0;
      lost += off > 45 && off <= 135 ? 1 : 0;
    }
  }

  /** Of the two numbers that an axis has: angles along the great circle to the nearer end. */
  static double nees(AxisState state, FlightTruth truth) {
    double[] t = {truth.ux(), truth.uy(), truth.uz()};
    double side = Vectors.dot(t, state.u()) < 0 ? -1 : 1;
    double a = side * Vectors.dot(t, state.e1());
    double b = side * Vectors.dot(t, state.e2());
    double sin = Math.hypot(a, b);
    double scale = sin < 1e-9 ? 1 : Math.atan2(sin, side * Vectors.dot(t, state.u())) / sin;
    double[] p = state.p();
    double determinant = p[0] * p[10] - p[2] * p[2];
    return scale * scale * (p[10] * a * a - 2 * p[2] * a * b + p[0] * b * b) / determinant;
  }

  public static double quantile(List<Double> values, double share) {
    double[] sorted = values.stream().mapToDouble(Double::doubleValue).toArray();
    Arrays.sort(sorted);
    return sorted.length == 0
        ? Double.NaN
        : sorted[(int) Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
  }

  static double mean(List<Double> values) {
    return values.stream().mapToDouble(Double::doubleValue).average().orElse(Double.NaN);
  }
}
