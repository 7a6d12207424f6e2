package haltere.filters.orientation;

import haltere.filters.estimation.FilterStep;
import haltere.filters.orientation.camera.CameraModel;
import haltere.filters.orientation.camera.LineObservation;
import haltere.filters.orientation.camera.Vectors;
import haltere.filters.orientation.internal.axis.AxisFilter;
import haltere.filters.orientation.internal.axis.AxisLaunch;
import haltere.filters.orientation.internal.axis.LineMeasurement;
import haltere.filters.orientation.internal.axis.QuaternionFilter;
import haltere.filters.orientation.internal.axis.SphereFilter;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * Position and orientation of one body from the observations of calibrated cameras. Each estimate
 * uses the observations up to its time.
 *
 * <pre>{@code
 * BodyOrientationEstimator body =
 *     new BodyOrientationEstimator(cameras, OrientationSettings.defaults());
 * body.update(timeUs, List.of(new LineObservation(0, x, y, angle, area, ratio), ...))
 *     .ifPresent(now -> ...);
 * }</pre>
 *
 * <p>The position is estimated from the pixels (extended Kalman filter over position and velocity),
 * the axis from the angles (error-state filter on the sphere, or quaternions), the head from the
 * displacement along the axis. Unusable observations are counted and ignored. Cameras need not
 * expose at the same time: a call takes the observations of one time, and a start the last
 * sufficiently recent one of each camera.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class BodyOrientationEstimator {
  /** Variance of the axis above which it is unknown. */
  private static final double LOST_VARIANCE = Math.toRadians(50) * Math.toRadians(50);

  /** Variance of the axis up to which a change of sign is an exchange of its ends. */
  private static final double CLEAR_VARIANCE = Math.toRadians(15) * Math.toRadians(15);

  /** Variance of the direction of flight above which it is unknown, squared radians. */
  private static final double MAX_FLIGHT_VARIANCE = 0.1;

  /** Time constant of the angle between axis and flight. */
  private static final double SLIP_TIME_S = 0.1;

  private final OrientationSettings settings;
  private final Map<OrientationCount, Long> counts = new EnumMap<>(OrientationCount.class);
  private final LineIntake intake;
  private final LineNoise noise;
  private final PositionFilter position;
  final AxisFilter axis;
  private final AxisLaunch search;
  private final HeadOrTail head;
  private final FlightDirection flight = new FlightDirection();
  private final LineMeasurement[] lines;
  private final LineMeasurement[] views;
  private final double[] at = new double[3];
  private final double[] before = new double[3];
  private final double[] vector = new double[3];
  private double[] uSettled = new double[3];
  private double[] uBefore = new double[3];
  private boolean wasClear;
  private boolean hasTime;
  private long lastUs;
  private long seenUs;
  private boolean hasAxis;
  private boolean hadAxis;
  private boolean hasBefore;
  private double nisSum;
  private long nisCount;
  private int measured;

  /**
   * An estimator in its initial state.
   *
   * @param cameras in the order of {@link LineObservation#camera}; those with a {@link
   *     CameraModel#problem} are ignored
   * @param settings of the estimator
   */
  public BodyOrientationEstimator(List<CameraModel> cameras, OrientationSettings settings) {
    this.settings = settings;
    int count = cameras.size();
    noise = new LineNoise(settings.line(), count);
    intake = new LineIntake(List.copyOf(cameras), settings, noise);
    position = new PositionFilter(List.copyOf(cameras), settings.position());
    axis =
        settings.form() == OrientationSettings.Form.QUATERNION
            ? new QuaternionFilter(settings.axisModel())
            : new SphereFilter(settings.axisModel());
    search = new AxisLaunch(settings.gate().outlierShare());
    head = new HeadOrTail(settings.direction());
    lines = measurements(count);
    views = measurements(count);
  }

  private static LineMeasurement[] measurements(int count) {
    LineMeasurement[] all = new LineMeasurement[count];
    Arrays.setAll(all, i -> new LineMeasurement());
    return all;
  }

  /**
   * Estimates the orientation at a time with its observations.
   *
   * @param timeUs microseconds; a time before the last one is rejected
   * @param seen observations of this time, at most one of each camera
   * @return the orientation at this time, or empty if it is unknown
   */
  public Optional<OrientationEstimate> update(long timeUs, List<LineObservation> seen) {
    if (hasTime && timeUs < lastUs) {
      count(OrientationCount.OUT_OF_ORDER, seen.size());
      return Optional.empty();
    }
    double dtS = hasTime ? (timeUs - lastUs) * 1e-6 : 0;
    if (hasTime && timeUs - seenUs > settings.position().maxGapS() * 1e6) {
      position.stop();
      flight.forget();
      hasAxis = false;
    }
    hasTime = true;
    lastUs = timeUs;
    intake.accept(timeUs, seen, this::count);
    if (!intake.usable().isEmpty()) {
      seenUs = timeUs;
    }
    measured = 0;
    if (!locate(timeUs, dtS)) {
      count(OrientationCount.NO_POSITION, 1);
      hasAxis = false;
      return Optional.empty();
    }
    return orient(timeUs, dtS);
  }

  private boolean locate(long timeUs, double dtS) {
    hasBefore = position.isRunning();
    if (hasBefore) {
      position.position(before);
      position.predict(dtS);
      position.update(intake.usable());
    }
    if (!position.isRunning() || position.isLost()) {
      hasBefore = false;
      if (!position.launch(intake.recent(timeUs)) && !position.isRunning()) {
        return false;
      }
    }
    position.position(at);
    return true;
  }

  private Optional<OrientationEstimate> orient(long timeUs, double dtS) {
    int count = intake.measure(intake.usable(), at, lines, this::count);
    measured = count;
    int skipped = intake.usable().size() - count;
    int taken = count;
    if (hasAxis) {
      axis.predict(dtS);
      axis.update(lines, count);
      taken = note(count);
      coupleToFlight(dtS);
      hasAxis = axis.isValid() && (axis.axis().variance() <= LOST_VARIANCE || taken > 0);
      if (hasAxis && axis.needsSearch(lines, count) && finds(timeUs) && axis.offer(search)) {
        head.clearDisplacement();
        count(OrientationCount.REINITIALISED, 1);
      }
    }
    if (!hasAxis) {
      boolean isOpen = settings.gate().angleDeg() > 0;
      if (!isOpen || !finds(timeUs)) {
        count(OrientationCount.REJECTED, isOpen ? 0 : count);
        count(OrientationCount.NO_AXIS, 1);
        return Optional.empty();
      }
      start(count);
      taken = count;
    }
    return Optional.of(estimate(timeUs, dtS, taken, count - taken + skipped));
  }

  /** Coupling of the axis to the direction of flight, with a random slip angle. */
  private void coupleToFlight(double dtS) {
    if (hasBefore) {
      flight.step(before, at, dtS);
    }
    double slip = Math.toRadians(settings.direction().slipSdDeg());
    double lengthM = flight.direction(vector);
    if (dtS > 0 && slip < Math.PI / 2 && lengthM > 0) {
      double variance = 2 * position.variance(vector) / (lengthM * lengthM);
      if (variance < MAX_FLIGHT_VARIANCE) {
        axis.coupleToFlight(
            Vectors.scaled(head.sign(), vector),
            slip * slip + variance,
            Math.min(1, dtS / SLIP_TIME_S));
      }
    }
  }

  /** Searches an axis in recent lines; its head follows from the last axis and the flight. */
  private boolean finds(long timeUs) {
    int count = intake.measure(intake.recent(timeUs), at, views, (problem, number) -> {});
    if (!search.find(views, count)) {
      return false;
    }
    if (hadAxis && isAgainst(search.axis())) {
      search.reverse();
    }
    return true;
  }

  /** Whether the found axis points to the tail, by the last settled axis and by the flight. */
  private boolean isAgainst(double[] found) {
    position.velocity(vector);
    double speed = Math.max(1e-9, Vectors.length(vector));
    return head.sign() * Vectors.dot(found, vector) / speed + Vectors.dot(found, uSettled) < 0;
  }

  /** Initialises the axis with the lines of this time. */
  private void start(int count) {
    if (hadAxis) {
      head.clearDisplacement();
      count(OrientationCount.REINITIALISED, 1);
    }
    axis.launch(search);
    hasAxis = true;
    count(OrientationCount.USED, count);
    for (int i = 0; i < count; i++) {
      lines[i].used = true;
    }
  }

  /** Counts used and rejected lines and estimates their noise; returns the number of used ones. */
  private int note(int count) {
    int taken = 0;
    for (int i = 0; i < count; i++) {
      LineMeasurement each = lines[i];
      if (each.used) {
        taken++;
        nisSum += each.nis;
        noise.update(each);
      }
    }
    nisCount += taken;
    count(OrientationCount.USED, taken);
    count(OrientationCount.REJECTED, count - taken);
    return taken;
  }

  private OrientationEstimate estimate(long timeUs, double dtS, int taken, int rejected) {
    AxisFilter.Axis now = axis.axis();
    double[] u = now.u();
    boolean isClear = now.variance() <= CLEAR_VARIANCE;
    if (hadAxis && isClear && wasClear && Vectors.dot(u, uBefore) < 0) {
      head.reverse(); // no body turns that fast
    }
    wasClear = isClear;
    uBefore = u;
    if (hasBefore && hadAxis) {
      double along = Vectors.dot(at, u) - Vectors.dot(before, u);
      head.step(along, position.variance(u), dtS);
    }
    uSettled = !hadAxis || now.isSettled() ? u : uSettled;
    hadAxis = true;
    // axis and head are both right, or both wrong
    double headProbability =
        now.agreement() * head.probability() + (1 - now.agreement()) * (1 - head.probability());
    return OrientationEstimate.of(
        timeUs,
        at,
        Vectors.scaled(head.sign(), u),
        Vectors.scaled(head.sign(), now.tipVelocity()),
        Math.sqrt(now.variance()),
        now.rollSd(),
        now.rollRate(),
        headProbability,
        taken,
        rejected);
  }

  /** Records each step of the axis and passes on those of the position; allocates. */
  void record(Consumer<? super FilterStep> positionSteps) {
    axis.record();
    position.record(positionSteps);
  }

  private void count(OrientationCount what, long number) {
    counts.merge(what, number, Long::sum);
  }

  /**
   * The count of a result.
   *
   * @param what the result
   * @return at least 0
   */
  public long count(OrientationCount what) {
    return counts.getOrDefault(what, 0L);
  }

  /**
   * Standard deviation of the angles of a camera, as set or estimated.
   *
   * @param camera its index
   * @return radians
   */
  public double lineSdRad(int camera) {
    return noise.sdRad(camera);
  }

  /**
   * Angle between the observed and the expected line of a camera at the last time.
   *
   * @param camera its index
   * @return radians in (−π/2, π/2), NaN without an observation
   */
  public double residualRad(int camera) {
    return measurement(camera).map(each -> each.residualRad).orElse(Double.NaN);
  }

  /**
   * Whether the line of a camera at the last time was used.
   *
   * @param camera its index
   * @return false also without an observation
   */
  public boolean used(int camera) {
    return measurement(camera).map(each -> each.used).orElse(false);
  }

  private Optional<LineMeasurement> measurement(int camera) {
    return Arrays.stream(lines, 0, measured).filter(each -> each.camera == camera).findAny();
  }

  /**
   * The observation of a camera at the last time.
   *
   * @param camera its index
   * @return empty if there was none
   */
  public Optional<LineObservation> observation(int camera) {
    return intake.usable().stream().filter(each -> each.camera() == camera).findAny();
  }

  /**
   * {@return the mean normalised innovation squared of all used lines: near 1 if the filter is
   * consistent (slightly less because of the gate), NaN before the first line}
   */
  public double meanNis() {
    return nisCount == 0 ? Double.NaN : nisSum / nisCount;
  }
}
