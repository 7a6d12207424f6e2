package haltere.filters.orientation;

import haltere.filters.estimation.Correction;
import haltere.filters.estimation.Estimate;
import haltere.filters.estimation.FilterStep;
import haltere.filters.estimation.RtsSmoother;
import haltere.filters.orientation.camera.CameraModel;
import haltere.filters.orientation.camera.LineObservation;
import haltere.filters.orientation.camera.Vectors;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;

/**
 * A body's whole track: what {@link BodyOrientationEstimator} says of it, kept, so that each time
 * can have the benefit of what came after it. Memory grows with the track, by about 3 kB a time.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class OrientationTrack {
  /** What was said at a time, and where its steps are. */
  private record Instant(OrientationEstimate online, int place, AxisStep axis) {}

  private final OrientationSettings settings;
  private final BodyOrientationEstimator estimator;
  private final List<FilterStep> placeSteps = new ArrayList<>();
  private final List<Instant> instants = new ArrayList<>();
  private int places = -1;

  /**
   * A track without a time.
   *
   * @param cameras the cameras
   * @param settings what to do
   */
  public OrientationTrack(List<CameraModel> cameras, OrientationSettings settings) {
    this.settings = settings;
    estimator = new BodyOrientationEstimator(cameras, settings);
    estimator.record(this::addPlaceStep);
  }

  private void addPlaceStep(FilterStep step) {
    boolean correction = step instanceof Correction;
    int last = placeSteps.size() - 1;
    if (!correction) {
      places++;
    }
    if (correction && last >= 0 && placeSteps.get(last) instanceof Correction) {
      placeSteps.set(last, step); // only the last one of a time is gone back over
    } else {
      placeSteps.add(step);
    }
  }

  /**
   * Goes on to a time, as {@link BodyOrientationEstimator#update}.
   *
   * @param timeUs microseconds
   * @param seen what cameras saw then
   * @return the orientation from what was seen up to then
   */
  public Optional<OrientationEstimate> update(long timeUs, List<LineObservation> seen) {
    Optional<OrientationEstimate> now = estimator.update(timeUs, seen);
    now.ifPresent(estimate -> instants.add(new Instant(estimate, places, estimator.axisStep())));
    return now;
  }

  /**
   * The estimator that the track is made with.
   *
   * @return for its counts
   */
  public BodyOrientationEstimator estimator() {
    return estimator;
  }

  /**
   * The whole track, smoothed, with head and tail chosen over all of it.
   *
   * @return an estimate for each one that {@link #update} has returned; its {@code headProbability}
   *     is NaN
   */
  public List<OrientationEstimate> smoothed() {
    List<Estimate> placesNow = RtsSmoother.smooth(placeSteps);
    List<double[]> axes = new ArrayList<>();
    List<double[]> tips = new ArrayList<>();
    List<double[]> velocities = new ArrayList<>();
    double[] sds = new double[instants.size()];
    double[] weights = new double[instants.size()];
    boolean[] linked = new boolean[instants.size()];
    boolean onSphere = settings.form() == OrientationSettings.Form.ERROR_STATE;
    List<AxisStep> steps = onSphere ? way() : List.of();
    List<AxisState> states = AxisSmoother.smooth(steps);
    for (int k = 0; k < instants.size(); k++) {
      OrientationEstimate online = instants.get(k).online();
      Estimate place = placesNow.get(instants.get(k).place());
      double[] velocity = {place.value(1), place.value(3), place.value(5)};
      velocities.add(velocity);
      double speed = Vectors.length(velocity);
      double sd =
          Math.sqrt(
              (place.covariance().get(1, 1)
                      + place.covariance().get(3, 3)
                      + place.covariance().get(5, 5))
                  / 3);
      weights[k] =
          onSphere ? DirectionChoice.weightOf(speed, sd) : DirectionChoice.originalWeight(speed);
      if (onSphere) {
        AxisState state = states.get(k);
        axes.add(state.u());
        double[] tip = new double[3];
        for (int i = 0; i < 3; i++) {
          tip[i] = state.va() * state.e1()[i] + state.vb() * state.e2()[i];
        }
        tips.add(tip);
        sds[k] = Math.sqrt(state.p()[0] + state.p()[10]);
        linked[k] = steps.get(k).predicted() != null;
      } else {
        axes.add(new double[] {online.ux(), online.uy(), online.uz()});
        sds[k] = online.sdAxisRad();
        linked[k] = k > 0;
      }
    }
    if (!onSphere) {
      axes = smoothVectors(axes, velocities, weights, linked);
      tips = differences(axes);
    }
    boolean[] flips = DirectionChoice.flips(axes, velocities, weights, linked);
    List<OrientationEstimate> track = new ArrayList<>(instants.size());
    for (int k = 0; k < instants.size(); k++) {
      track.add(
          estimate(
              instants.get(k).online(),
              placesNow.get(instants.get(k).place()),
              axes.get(k),
              tips.get(k),
              sds[k],
              flips[k]));
    }
    return track;
  }

  /** The way that led to the end, of which more is known there than there was on the way. */
  private List<AxisStep> way() {
    List<AxisStep> way = new ArrayList<>();
    AxisStep step = null;
    for (int k = instants.size() - 1; k >= 0; k--) {
      step = step == null ? instants.get(k).axis() : step;
      way.add(step);
      step = step.before();
    }
    Collections.reverse(way);
    return way;
  }

  private List<double[]> smoothVectors(
      List<double[]> axes, List<double[]> velocities, double[] weights, boolean[] linked) {
    boolean[] flips = DirectionChoice.flips(axes, velocities, weights, linked);
    List<double[]> signed = new ArrayList<>();
    List<Long> timesUs = new ArrayList<>();
    for (int k = 0; k < axes.size(); k++) {
      double sign = flips[k] ? -1 : 1;
      double[] u = axes.get(k);
      signed.add(new double[] {sign * u[0], sign * u[1], sign * u[2]});
      timesUs.add(instants.get(k).online().timeUs());
    }
    return UnitVectorSmoother.smooth(signed, timesUs);
  }

  /** Velocity of the tip from neighbouring axes of the same side. */
  private List<double[]> differences(List<double[]> axes) {
    List<double[]> tips = new ArrayList<>();
    for (int k = 0; k < axes.size(); k++) {
      int before = Math.max(0, k - 1);
      int after = Math.min(axes.size() - 1, k + 1);
      double dtS =
          (instants.get(after).online().timeUs() - instants.get(before).online().timeUs()) * 1e-6;
      double side = Vectors.dot(axes.get(before), axes.get(after)) < 0 ? -1 : 1;
      double[] tip = new double[3];
      for (int i = 0; i < 3 && dtS > 0; i++) {
        tip[i] = (axes.get(after)[i] - side * axes.get(before)[i]) / dtS;
      }
      tips.add(tip);
    }
    return tips;
  }

  private static OrientationEstimate estimate(
      OrientationEstimate online,
      Estimate place,
      double[] u,
      double[] tip,
      double sd,
      boolean flip) {
    double sign = flip ? -1 : 1;
    double[] directed = {sign * u[0], sign * u[1], sign * u[2]};
    double[] rates =
        OrientationEstimate.rates(
            directed, new double[] {sign * tip[0], sign * tip[1], sign * tip[2]});
    return new OrientationEstimate(
        online.timeUs(),
        place.value(0),
        place.value(2),
        place.value(4),
        directed[0],
        directed[1],
        directed[2],
        Math.min(OrientationEstimate.RANDOM_SD, sd),
        online.sdRollRad(),
        online.pRadS(),
        rates[0],
        rates[1],
        Double.NaN,
        online.used(),
        online.rejected());
  }
}
