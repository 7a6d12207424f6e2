package haltere.filters.orientation;

import haltere.filters.estimation.FilterStep;
import haltere.filters.orientation.camera.CameraModel;
import haltere.filters.orientation.camera.LineObservation;
import haltere.filters.orientation.camera.Vectors;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * Place and orientation of one body from what any number of calibrated cameras see of it, at each
 * instant from what was seen up to then.
 *
 * <pre>{@code
 * BodyOrientationEstimator body =
 *     new BodyOrientationEstimator(cameras, OrientationSettings.defaults());
 * body.update(timeUs, List.of(new LineObservation(0, x, y, angle, area, ratio), ...))
 *     .ifPresent(now -> ...);
 * }</pre>
 *
 * <p>The place comes from the pixels (an extended Kalman filter over place and velocity), the axis
 * from the angles (an error-state filter on the sphere, or quaternions), head or tail from the way
 * flown. What cannot be used is counted and changes nothing. Cameras need not look at the same
 * time: each call brings what was seen at one time, and a start takes the last view of each camera
 * that is recent enough.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class BodyOrientationEstimator {
  /** Variance of the axis beyond which it is as good as unknown. */
  private static final double LOST_VARIANCE = Math.toRadians(50) * Math.toRadians(50);

  /** Variance of the axis up to which it is the same one as an instant ago. */
  private static final double VAGUE_VARIANCE = Math.toRadians(15) * Math.toRadians(15);

  /** Squared angle up to which the direction of flight is known. */
  private static final double CLEAR_COURSE = 0.1;

  /** How long an axis stays off the direction of flight by the same angle. */
  private static final double SLIP_LASTS_S = 0.1;

  private final List<CameraModel> cameras;
  private final OrientationSettings settings;
  private final OrientationCounts counts = new OrientationCounts();
  private final LineIntake intake;
  private final LineNoise noise;
  private final LineGate gate;
  private final PositionFilter position;
  private final AxisFilter axis;
  private final AxisLaunch search;
  private final HeadOrTail head;
  private final Course course = new Course();
  private final LineMeasurement[] lines;
  private final LineMeasurement[] views;
  private final double[] residuals;
  private final boolean[] used;
  private final double[] place = new double[3];
  private final double[] placeBefore = new double[3];
  private final double[] u = new double[3];
  private final double[] tip = new double[3];
  private final double[] uAgreed = new double[3];
  private final double[] uBefore = new double[3];
  private boolean wasClear;

  private boolean hasTime;
  private long lastUs;
  private long seenUs;
  private boolean hasAxis;
  private boolean hadAxis;
  private boolean hasPlaceBefore;
  private double nisSum;
  private long nisCount;

  /**
   * An estimator that has seen nothing.
   *
   * @param cameras the cameras that {@link LineObservation#camera} counts; those with a {@link
   *     CameraModel#problem} are left out
   * @param settings what to do
   */
  public BodyOrientationEstimator(List<CameraModel> cameras, OrientationSettings settings) {
    this.cameras = List.copyOf(cameras);
    this.settings = Objects.requireNonNull(settings, "settings");
    int count = this.cameras.size();
    intake = new LineIntake(this.cameras, settings.position().togetherS(), counts);
    noise = new LineNoise(settings.line(), count);
    gate = new LineGate(settings.gate(), noise);
    position = new PositionFilter(this.cameras, settings.position());
    axis =
        settings.form() == OrientationSettings.Form.QUATERNION
            ? new QuaternionFilter(settings)
            : new SphereFilter(settings);
    search = new AxisLaunch(settings.gate().outlierShare());
    head = new HeadOrTail(settings.direction());
    lines = measurements(count);
    views = measurements(count);
    residuals = new double[count];
    used = new boolean[count];
  }

  private static LineMeasurement[] measurements(int count) {
    LineMeasurement[] all = new LineMeasurement[count];
    Arrays.setAll(all, i -> new LineMeasurement());
    return all;
  }

  /**
   * Goes on to a time and takes in what was seen then.
   *
   * @param timeUs microseconds; one before the last is refused
   * @param seen what cameras saw at this time, at most once each
   * @return the orientation at this time, or empty as long as it is not known
   */
  public Optional<OrientationEstimate> update(long timeUs, List<LineObservation> seen) {
    if (hasTime && timeUs < lastUs) {
      counts.add(OrientationCount.TIME_BACK, seen.size());
      return Optional.empty();
    }
    double dtS = hasTime ? (timeUs - lastUs) * 1e-6 : 0;
    if (hasTime && timeUs - seenUs > settings.position().longestGapS() * 1e6) {
      position.stop();
      course.forget();
      hasAxis = false;
    }
    hasTime = true;
    lastUs = timeUs;
    intake.take(timeUs, seen);
    if (!intake.usable().isEmpty()) {
      seenUs = timeUs;
    }
    Arrays.fill(residuals, Double.NaN);
    Arrays.fill(used, false);
    if (!locate(timeUs, dtS)) {
      counts.add(OrientationCount.NO_PLACE, 1);
      hasAxis = false;
      return Optional.empty();
    }
    return orient(timeUs, dtS);
  }

  private boolean locate(long timeUs, double dtS) {
    hasPlaceBefore = position.isRunning();
    if (hasPlaceBefore) {
      position.position(placeBefore);
      position.predict(dtS);
      position.update(intake.usable());
    }
    if (!position.isRunning() || position.isLost()) {
      hasPlaceBefore = false;
      if (!position.launch(intake.recent(timeUs)) && !position.isRunning()) {
        return false;
      }
    }
    position.position(place);
    return true;
  }

  private Optional<OrientationEstimate> orient(long timeUs, double dtS) {
    int skipped = 0;
    int count = 0;
    for (LineObservation observation : intake.usable()) {
      Optional<OrientationCount> why =
          gate.prepare(observation, cameras.get(observation.camera()), place, lines[count]);
      if (why.isEmpty()) {
        count++;
      } else {
        counts.add(why.get(), 1);
        skipped++;
      }
    }
    int taken = 0;
    if (hasAxis) {
      axis.predict(dtS);
      axis.update(lines, count);
      taken = note(count);
      coupleToFlight(dtS);
      hasAxis = axis.isSound() && (axis.axisVariance() <= LOST_VARIANCE || taken > 0);
      if (hasAxis && axis.doubts(lines, count) && finds(timeUs) && axis.offer(search)) {
        head.doubt();
        counts.add(OrientationCount.RELAUNCHED, 1);
      }
    }
    if (!hasAxis) {
      boolean isOpen = settings.gate().angleDeg() > 0;
      if (!isOpen || !finds(timeUs)) {
        counts.add(OrientationCount.REJECTED, isOpen ? 0 : count);
        counts.add(OrientationCount.NO_AXIS, 1);
        return Optional.empty();
      }
      start(count);
      taken = count;
    }
    return Optional.of(estimate(timeUs, dtS, taken, count - taken + skipped));
  }

  /** A body that flies points more or less to where it flies. */
  private void coupleToFlight(double dtS) {
    if (hasPlaceBefore) {
      course.step(placeBefore, place, dtS);
    }
    double slip = Math.toRadians(settings.direction().slipSdDeg());
    if (dtS > 0 && slip < Math.PI / 2 && course.direction(tip)) {
      double noise = 2 * position.variance(tip) / (course.lengthM() * course.lengthM());
      if (noise < CLEAR_COURSE) {
        double sign = head.isFlipped() ? -1 : 1;
        for (int k = 0; k < 3; k++) {
          tip[k] *= sign;
        }
        axis.coupleToFlight(tip, slip * slip + noise, Math.min(1, dtS / SLIP_LASTS_S));
      }
    }
  }

  /** Looks for an axis in what goes together; its head is where the body's was or flies to. */
  private boolean finds(long timeUs) {
    int count = 0;
    for (LineObservation observation : intake.recent(timeUs)) {
      if (gate.prepare(observation, cameras.get(observation.camera()), place, views[count])
          .isEmpty()) {
        count++;
      }
    }
    if (!search.find(views, count)) {
      return false;
    }
    if (hadAxis && isAgainst(search.axis())) {
      search.turnRound();
    }
    return true;
  }

  /**
   * Whether an axis that was found anew points to the tail, by where the head last was for sure and
   * by where the body flies.
   */
  private boolean isAgainst(double[] found) {
    position.velocity(tip);
    double speed = Math.max(1e-9, Vectors.length(tip));
    double sign = head.isFlipped() ? -1 : 1;
    return sign * Vectors.dot(found, tip) / speed + Vectors.dot(found, uAgreed) < 0;
  }

  /** Initialises the axis with the lines of this instant. */
  private void start(int count) {
    if (hadAxis) {
      head.doubt();
      counts.add(OrientationCount.RELAUNCHED, 1);
    }
    axis.launch(search);
    hasAxis = true;
    counts.add(OrientationCount.USED, count);
    for (int i = 0; i < count; i++) {
      used[lines[i].camera] = true;
    }
  }

  /** Counts what became of the lines and learns their noise; returns how many were used. */
  private int note(int count) {
    int taken = 0;
    for (int i = 0; i < count; i++) {
      LineMeasurement each = lines[i];
      residuals[each.camera] = each.residualRad;
      used[each.camera] = each.used;
      if (each.used) {
        taken++;
        nisSum += each.nis;
        nisCount++;
        noise.learn(each);
      }
    }
    counts.add(OrientationCount.USED, taken);
    counts.add(OrientationCount.REJECTED, count - taken);
    return taken;
  }

  private OrientationEstimate estimate(long timeUs, double dtS, int taken, int rejected) {
    axis.axis(u);
    boolean clear = axis.axisVariance() <= VAGUE_VARIANCE;
    if (hadAxis && clear && wasClear && Vectors.dot(u, uBefore) < 0) {
      head.turnRound(); // no body turns that fast
    }
    wasClear = clear;
    System.arraycopy(u, 0, uBefore, 0, 3);
    if (hasPlaceBefore && hadAxis) {
      double along = 0;
      for (int k = 0; k < 3; k++) {
        along += (place[k] - placeBefore[k]) * u[k];
      }
      head.step(along, position.variance(u), dtS);
    }
    if (!hadAxis || axis.isSettled()) {
      System.arraycopy(u, 0, uAgreed, 0, 3);
    }
    hadAxis = true;
    axis.tipVelocity(tip);
    double sign = head.isFlipped() ? -1 : 1;
    double[] directed = {sign * u[0], sign * u[1], sign * u[2]};
    double[] directedTip = {sign * tip[0], sign * tip[1], sign * tip[2]};
    double[] rates = OrientationEstimate.rates(directed, directedTip);
    return new OrientationEstimate(
        timeUs,
        place[0],
        place[1],
        place[2],
        directed[0],
        directed[1],
        directed[2],
        Math.min(OrientationEstimate.RANDOM_SD, Math.sqrt(axis.axisVariance())),
        axis.rollSd(),
        axis.rollRate(),
        rates[0],
        rates[1],
        headProbability(),
        taken,
        rejected);
  }

  /** That the true axis is on this side and its head ahead, or neither. */
  private double headProbability() {
    double near = axis.agreement();
    return near * head.probability() + (1 - near) * (1 - head.probability());
  }

  /** From now on keeps each step of the axis and hands out those of the place; this allocates. */
  void record(Consumer<? super FilterStep> placeSteps) {
    axis.record();
    position.record(placeSteps);
  }

  /** The last instant of the axis with the way to it; null if its form has no smoother. */
  AxisStep axisStep() {
    return axis.step();
  }

  /**
   * How often something happened.
   *
   * @param what which
   * @return at least 0
   */
  public long count(OrientationCount what) {
    return counts.of(what);
  }

  /**
   * Standard deviation of a camera's angles, as set or as learnt so far.
   *
   * @param camera its index
   * @return radians
   */
  public double lineSdRad(int camera) {
    return noise.sdRad(camera);
  }

  /**
   * Angle between what a camera saw at the last instant and what was expected.
   *
   * @param camera its index
   * @return radians in (−π/2, π/2), NaN if it saw nothing then
   */
  public double residualRad(int camera) {
    return residuals[camera];
  }

  /**
   * Whether the line that a camera saw at the last instant was used.
   *
   * @param camera its index
   * @return false as well if it saw none
   */
  public boolean used(int camera) {
    return used[camera];
  }

  /**
   * What a camera observed at the last instant.
   *
   * @param camera its index
   * @return empty if it observed nothing then
   */
  public Optional<LineObservation> observation(int camera) {
    return intake.usable().stream().filter(each -> each.camera() == camera).findAny();
  }

  /** State of the axis after the last instant; without a covariance if it is of quaternions. */
  AxisState axisState() {
    return axis.state();
  }

  /**
   * Mean of the normalised innovations squared of all lines that were used: near 1 if the filter is
   * as sure as it says (somewhat less, since lines far off are left out).
   *
   * @return NaN before the first
   */
  public double meanNis() {
    return nisCount == 0 ? Double.NaN : nisSum / nisCount;
  }

  /**
   * How often head and tail were exchanged after they had been decided.
   *
   * @return at least 0
   */
  public long headChanges() {
    return head.changes();
  }
}
