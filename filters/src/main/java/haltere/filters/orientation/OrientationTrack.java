package haltere.filters.orientation;

import haltere.filters.estimation.Estimate;
import haltere.filters.estimation.FilterStep;
import haltere.filters.estimation.KalmanFilter;
import haltere.filters.estimation.LinearMeasurement;
import haltere.filters.estimation.RtsSmoother;
import haltere.filters.estimation.motion.AxisMotion;
import haltere.filters.orientation.camera.CameraModel;
import haltere.filters.orientation.camera.LineObservation;
import haltere.filters.orientation.camera.Vectors;
import haltere.filters.orientation.internal.axis.AxisSmoother;
import haltere.filters.orientation.internal.axis.AxisState;
import haltere.filters.orientation.internal.axis.AxisStep;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * The whole track of a body: stores the estimates of {@link BodyOrientationEstimator} for
 * smoothing. Memory grows with the track, by about 3 kB per time.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class OrientationTrack {
  /** An online estimate and the indexes of its steps. */
  private record Instant(OrientationEstimate online, int position, AxisStep axis) {}

  private final OrientationSettings settings;
  private final BodyOrientationEstimator estimator;
  private final List<FilterStep> positionSteps = new ArrayList<>();
  private final List<Instant> instants = new ArrayList<>();
  private int positions = -1;

  /**
   * A track without a time.
   *
   * @param cameras the cameras
   * @param settings of the estimator
   */
  public OrientationTrack(List<CameraModel> cameras, OrientationSettings settings) {
    this.settings = settings;
    estimator = new BodyOrientationEstimator(cameras, settings);
    estimator.record(this::addPositionStep);
  }

  private void addPositionStep(FilterStep step) {
    boolean isCorrection = step instanceof FilterStep.Correction;
    int last = positionSteps.size() - 1;
    positions += isCorrection ? 0 : 1;
    if (isCorrection && last >= 0 && positionSteps.get(last) instanceof FilterStep.Correction) {
      positionSteps.set(last, step); // the smoother needs only the last one of a time
    } else {
      positionSteps.add(step);
    }
  }

  /**
   * Adds a time, as {@link BodyOrientationEstimator#update}.
   *
   * @param timeUs microseconds
   * @param seen observations of this time
   * @return the orientation from the observations up to this time
   */
  public Optional<OrientationEstimate> update(long timeUs, List<LineObservation> seen) {
    Optional<OrientationEstimate> now = estimator.update(timeUs, seen);
    now.ifPresent(each -> instants.add(new Instant(each, positions, estimator.axis.step())));
    return now;
  }

  /** {@return the estimator of the track, for its counts} */
  public BodyOrientationEstimator estimator() {
    return estimator;
  }

  /**
   * The whole track, smoothed, with head and tail resolved over all of it.
   *
   * @return an estimate for each one that {@link #update} has returned; its {@code headProbability}
   *     is NaN
   */
  public List<OrientationEstimate> smoothed() {
    int count = instants.size();
    List<Estimate> all = RtsSmoother.smooth(positionSteps);
    List<Estimate> at = instants.stream().map(each -> all.get(each.position())).toList();
    List<double[]> velocities =
        at.stream().map(p -> new double[] {p.value(1), p.value(3), p.value(5)}).toList();
    boolean onSphere = settings.form() == OrientationSettings.Form.ERROR_STATE;
    List<AxisStep> steps = onSphere ? path() : List.of();
    List<AxisState> states = AxisSmoother.smooth(steps);
    List<double[]> axes = new ArrayList<>();
    double[] weights = new double[count];
    boolean[] linked = new boolean[count];
    for (int k = 0; k < count; k++) {
      OrientationEstimate online = instants.get(k).online();
      double speed = Vectors.length(velocities.get(k));
      weights[k] =
          onSphere
              ? DirectionChoice.weightOf(speed, speedSd(at.get(k)))
              : DirectionChoice.originalWeight(speed);
      linked[k] = onSphere ? steps.get(k).predicted() != null : k > 0;
      axes.add(onSphere ? states.get(k).u() : new double[] {online.ux(), online.uy(), online.uz()});
    }
    if (!onSphere) {
      axes = smoothAsPositions(axes, DirectionChoice.flips(axes, velocities, weights, linked));
    }
    boolean[] flips = DirectionChoice.flips(axes, velocities, weights, linked);
    List<OrientationEstimate> track = new ArrayList<>(count);
    for (int k = 0; k < count; k++) {
      OrientationEstimate online = instants.get(k).online();
      double[] tip = onSphere ? states.get(k).tipVelocity() : tipVelocity(axes, k);
      double[] p = onSphere ? states.get(k).p() : null;
      double sd = onSphere ? Math.sqrt(p[0] + p[10]) : online.sdAxisRad();
      double sign = flips[k] ? -1 : 1;
      track.add(
          OrientationEstimate.of(
              online.timeUs(),
              new double[] {at.get(k).value(0), at.get(k).value(2), at.get(k).value(4)},
              Vectors.scaled(sign, axes.get(k)),
              Vectors.scaled(sign, tip),
              sd,
              online.sdRollRad(),
              online.pRadS(),
              Double.NaN,
              online.used(),
              online.rejected()));
    }
    return track;
  }

  private static double speedSd(Estimate position) {
    double sum = 0;
    for (int i = 1; i < 6; i += 2) {
      sum += position.covariance().get(i, i);
    }
    return Math.sqrt(sum / 3);
  }

  /** The steps of the likeliest hypothesis at the end. */
  private List<AxisStep> path() {
    List<AxisStep> path = new ArrayList<>();
    AxisStep step = null;
    for (int k = instants.size() - 1; k >= 0; k--) {
      step = step == null ? instants.get(k).axis() : step;
      path.add(step);
      step = step.before();
    }
    Collections.reverse(path);
    return path;
  }

  /**
   * Smooths axes as Straw et al. (2011) do, for comparison: as if they were positions, with
   * constant velocity, Q = I and R = 30 I at each step, P = 2 I at first; then made of length 1
   * again.
   */
  private List<double[]> smoothAsPositions(List<double[]> axes, boolean[] flips) {
    List<FilterStep> steps = new ArrayList<>();
    LinearMeasurement measured = LinearMeasurement.ofEntries(6, 30, 0, 2, 4);
    DMatrixRMaj x = new DMatrixRMaj(6, 1);
    DMatrixRMaj z = new DMatrixRMaj(3, 1);
    DMatrixRMaj start = CommonOps_DDRM.identity(6);
    CommonOps_DDRM.scale(2, start);
    KalmanFilter filter = null;
    int[] predictions = new int[axes.size()];
    for (int k = 0; k < axes.size(); k++) {
      for (int i = 0; i < 3; i++) {
        z.set(i, (flips[k] ? -1 : 1) * axes.get(k)[i]);
        x.set(2 * i, z.get(i));
      }
      if (filter == null) {
        filter = new KalmanFilter(AxisMotion.constantVelocity(3, 0).withNoisePerStep(1), x, start);
        filter.observe(steps::add);
      } else {
        double dtS = secondsBetween(k - 1, k);
        filter.predict(dtS);
        predictions[k] = predictions[k - 1] + (dtS > 0 ? 1 : 0);
      }
      filter.update(measured, z);
    }
    List<Estimate> all = RtsSmoother.smooth(steps);
    List<double[]> smoothed = new ArrayList<>();
    for (int prediction : predictions) {
      Estimate each = all.get(prediction);
      double[] u = {each.value(0), each.value(2), each.value(4)};
      Vectors.normalise(u);
      smoothed.add(u);
    }
    return smoothed;
  }

  private double secondsBetween(int from, int to) {
    return (instants.get(to).online().timeUs() - instants.get(from).online().timeUs()) * 1e-6;
  }

  /** Velocity of the tip from neighbouring axes of the same side. */
  private double[] tipVelocity(List<double[]> axes, int k) {
    int before = Math.max(0, k - 1);
    int after = Math.min(axes.size() - 1, k + 1);
    double dtS = secondsBetween(before, after);
    double side = Vectors.dot(axes.get(before), axes.get(after)) < 0 ? -1 : 1;
    double[] tip = new double[3];
    for (int i = 0; i < 3 && dtS > 0; i++) {
      tip[i] = (axes.get(after)[i] - side * axes.get(before)[i]) / dtS;
    }
    return tip;
  }
}
