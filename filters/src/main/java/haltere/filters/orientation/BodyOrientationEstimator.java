package haltere.filters.orientation;

import haltere.filters.estimation.FilterStep;
import java.util.ArrayList;
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
  /** Instants in a row at which most lines were rejected, after which an axis is lost. */
  private static final int LOST_AFTER = 3;

  /** Lines of one camera that were rejected in a row, after which an axis is doubted. */
  private static final int BLIND_AFTER = 5;

  /** Instants at which all lines agreed, after which an axis is established. */
  private static final int ESTABLISHED = 3;

  /** Variance of the axis beyond which it is as good as unknown. */
  private static final double LOST_VARIANCE = Math.toRadians(50) * Math.toRadians(50);

  /** Detections that the learnt variance of a camera is a mean over. */
  private static final double NOISE_MEMORY = 300;

  private static final double SAME_AXIS = Math.cos(Math.toRadians(30));
  private static final double LEAST_SD = Math.toRadians(0.05);
  private static final double GREATEST_SD = Math.toRadians(30);

  private final List<CameraModel> cameras;
  private final OrientationSettings settings;
  private final PositionFilter position;
  private final AxisFilter axis;
  private final HeadOrTail head;
  private final double[] lineVariances;
  private final long[] counts = new long[OrientationCount.values().length];
  private final LineMeasurement[] lines;
  private final LineObservation[] latest;
  private final long[] latestUs;
  private final double[] residuals;
  private final boolean[] used;
  private final int[] rejections;
  private final double[] place = new double[3];
  private final double[] placeBefore = new double[3];
  private final double[] u = new double[3];
  private final double[] tip = new double[3];
  private final double[] candidate = new double[3];
  private final double[] uAgreed = new double[3];
  private final double[] covariance = new double[9];
  private final double[] line = new double[3];
  private final List<LineObservation> usable = new ArrayList<>();

  private Consumer<? super AxisStep> recorder;
  private boolean hasTime;
  private long lastUs;
  private long seenUs;
  private boolean hasAxis;
  private boolean hadAxis;
  private boolean hasPlaceBefore;
  private boolean hasCandidate;
  private long candidateUs;
  private int rejectedInstants;
  private int agreements;
  private boolean together;
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
    position = new PositionFilter(this.cameras, settings.position());
    axis =
        settings.form() == OrientationSettings.Form.QUATERNION
            ? new QuaternionFilter(settings)
            : new SphereFilter(settings);
    head = new HeadOrTail(settings.direction());
    int count = this.cameras.size();
    lines = new LineMeasurement[count];
    latest = new LineObservation[count];
    latestUs = new long[count];
    residuals = new double[count];
    used = new boolean[count];
    rejections = new int[count];
    lineVariances = new double[count];
    double sd = Math.toRadians(settings.line().angleSdDeg());
    for (int i = 0; i < count; i++) {
      lines[i] = new LineMeasurement();
      lineVariances[i] = sd * sd;
    }
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
      count(OrientationCount.TIME_BACK, seen.size());
      return Optional.empty();
    }
    double dtS = hasTime ? (timeUs - lastUs) * 1e-6 : 0;
    boolean fresh = !hasTime;
    hasTime = true;
    lastUs = timeUs;
    if (!fresh && timeUs - seenUs > settings.position().longestGapS() * 1e6) {
      position.stop();
      loseAxis();
      hasPlaceBefore = false;
    }
    take(timeUs, seen);
    if (!usable.isEmpty()) {
      seenUs = timeUs;
    }
    together |= usable.size() > 1;
    Arrays.fill(residuals, Double.NaN);
    Arrays.fill(used, false);
    if (!locate(timeUs, dtS)) {
      count(OrientationCount.NO_PLACE, 1);
      loseAxis();
      return Optional.empty();
    }
    return orient(timeUs, dtS);
  }

  /** Sorts out what cannot be used at all. */
  private void take(long timeUs, List<LineObservation> seen) {
    usable.clear();
    for (LineObservation observation : seen) {
      if (observation.camera() >= cameras.size()) {
        throw new IllegalArgumentException(
            "there is no camera " + observation.camera() + ", there are " + cameras.size());
      }
      if (cameras.get(observation.camera()).problem().isPresent()) {
        count(OrientationCount.UNUSABLE_CAMERA, 1);
      } else if (latest[observation.camera()] != null
          && latestUs[observation.camera()] == timeUs
          && usable.contains(latest[observation.camera()])) {
        count(OrientationCount.TWICE, 1);
      } else {
        usable.add(observation);
        latest[observation.camera()] = observation;
        latestUs[observation.camera()] = timeUs;
      }
    }
  }

  private boolean locate(long timeUs, double dtS) {
    hasPlaceBefore = position.isRunning();
    if (hasPlaceBefore) {
      position.place(placeBefore);
      position.predict(dtS);
      position.update(usable);
    }
    if (!position.isRunning() || position.isLost()) {
      hasPlaceBefore = false;
      if (!position.launch(recent(timeUs)) && !position.isRunning()) {
        return false;
      }
    }
    position.place(place);
    return true;
  }

  /**
   * What goes together: what was seen now if cameras look at the same times, else the last views
   * that are recent enough.
   */
  private List<LineObservation> recent(long timeUs) {
    if (together) {
      return usable;
    }
    List<LineObservation> views = new ArrayList<>();
    for (int i = 0; i < latest.length; i++) {
      if (latest[i] != null && timeUs - latestUs[i] <= settings.position().togetherS() * 1e6) {
        views.add(latest[i]);
      }
    }
    return views;
  }

  private Optional<OrientationEstimate> orient(long timeUs, double dtS) {
    int skipped = 0;
    int count = 0;
    for (LineObservation observation : usable) {
      if (prepare(observation, lines[count])) {
        count++;
      } else {
        skipped++;
      }
    }
    int taken = 0;
    if (hasAxis) {
      axis.predict(dtS);
      AxisState predicted = recorder != null ? predicted() : null;
      axis.update(lines, count);
      taken = note(count);
      if (!axis.isSound() || (axis.axisVariance() > LOST_VARIANCE && taken == 0)) {
        loseAxis();
      } else if (!isDoubtful(count, taken) || !launch(timeUs)) {
        if (recorder != null) {
          recorder.accept(new AxisStep(timeUs, predicted, transition(), current()));
        }
      }
    }
    if (!hasAxis) {
      if (!launch(timeUs)) {
        count(OrientationCount.NO_AXIS, 1);
        return Optional.empty();
      }
      taken = started(count);
    }
    return Optional.of(estimate(timeUs, dtS, taken, count - taken + skipped));
  }

  /** The lines of this instant that have started an axis; a gate that rejects all rejects them. */
  private int started(int count) {
    int taken = settings.gate().angleDeg() > 0 ? count : 0;
    count(OrientationCount.USED, taken);
    count(OrientationCount.REJECTED, count - taken);
    for (int i = 0; i < taken; i++) {
      used[lines[i].camera] = true;
    }
    return taken;
  }

  private boolean prepare(LineObservation observation, LineMeasurement into) {
    ObservationGateSettings gate = settings.gate();
    if (!Double.isFinite(observation.angleRad())) {
      count(OrientationCount.WITHOUT_ANGLE, 1);
      return false;
    }
    if (observation.areaPx() <= gate.minAreaPx() && gate.minAreaPx() > 0) {
      count(OrientationCount.SMALL, 1);
      return false;
    }
    double ratio = observation.axisRatio();
    if (gate.minEccentricity() > 0 && ratio <= gate.minEccentricity()) {
      count(OrientationCount.ROUND, 1);
      return false;
    }
    CameraModel camera = cameras.get(observation.camera());
    line[0] = observation.xPx();
    line[1] = observation.yPx();
    line[2] = observation.angleRad();
    if (!observation.hasPlace() && !camera.project(place, line)) {
      count(OrientationCount.WITHOUT_LINE, 1);
      return false;
    }
    if (!camera.straighten(line)) {
      count(OrientationCount.UNUSABLE_CAMERA, 1);
      return false;
    }
    if (!camera.lineNormals(place, into.n)) {
      count(OrientationCount.WITHOUT_LINE, 1);
      return false;
    }
    into.camera = observation.camera();
    into.angleRad = line[2];
    into.roundness = settings.line().byEccentricity() ? roundness(ratio) : 1;
    into.varianceRad2 = lineVariances[into.camera] * into.roundness;
    return true;
  }

  /**
   * How much larger the variance of an ellipse's angle is than that of one with the ratio 2: it
   * goes with (ρ / (ρ² − 1))², the derivative of the angle by the second moments.
   */
  private static double roundness(double ratio) {
    if (Double.isNaN(ratio) || ratio >= 2) {
      return 1;
    }
    double lever = 1.5 * ratio / Math.max(1e-3, ratio * ratio - 1);
    return Math.min(400, lever * lever);
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
        learn(each);
      }
    }
    count(OrientationCount.USED, taken);
    count(OrientationCount.REJECTED, count - taken);
    return taken;
  }

  /**
   * Whether the axis had better be looked for anew. A young one, which may have begun with a line
   * that was none, as soon as one is rejected; an established one when most lines are rejected
   * several times in a row, or those of one camera longer.
   */
  private boolean isDoubtful(int count, int taken) {
    for (int i = 0; i < count; i++) {
      rejections[lines[i].camera] = lines[i].used ? 0 : rejections[lines[i].camera] + 1;
    }
    if (count == 0) {
      return false;
    }
    boolean most = count <= 2 ? taken < count : 2 * taken <= count;
    rejectedInstants = most ? rejectedInstants + 1 : 0;
    if (taken == count) {
      agreements = Math.min(ESTABLISHED, count < 2 ? agreements : agreements + 1);
      return false;
    }
    int longest = 0;
    for (int i = 0; i < count; i++) {
      longest = Math.max(longest, rejections[lines[i].camera]);
    }
    return agreements < ESTABLISHED || rejectedInstants >= LOST_AFTER || longest >= BLIND_AFTER;
  }

  /** One step of expectation and maximisation: R is the mean of ε² + H P⁺ Hᵀ. */
  private void learn(LineMeasurement each) {
    double now = each.afterRad2 / each.roundness;
    if (settings.line().calibrate() && Double.isFinite(now)) {
      double variance = lineVariances[each.camera];
      variance += (now - variance) / NOISE_MEMORY;
      lineVariances[each.camera] =
          Math.min(GREATEST_SD * GREATEST_SD, Math.max(LEAST_SD * LEAST_SD, variance));
    }
  }

  private boolean launch(long timeUs) {
    int count = 0;
    long[] noted = counts.clone();
    for (LineObservation observation : recent(timeUs)) {
      if (prepare(observation, lines[count])) {
        count++;
      }
    }
    System.arraycopy(noted, 0, counts, 0, counts.length);
    if (!AxisLaunch.find(lines, count, u, covariance)) {
      return false;
    }
    boolean replaces = hasAxis && agreements >= ESTABLISHED;
    if (replaces && count == 2 && !isConfirmed(timeUs)) {
      return false;
    }
    if (hadAxis) {
      head.doubt();
      if (isAgainst()) {
        for (int k = 0; k < 3; k++) {
          u[k] = -u[k];
        }
      }
      count(OrientationCount.RELAUNCHED, 1);
    }
    axis.launch(u, covariance);
    hasAxis = true;
    forgetDoubts();
    // Three lines with an axis in common are no chance, nor is one that was found twice.
    agreements = count > 2 || replaces ? ESTABLISHED : 0;
    if (recorder != null) {
      recorder.accept(new AxisStep(timeUs, null, null, current()));
    }
    return true;
  }

  /**
   * Two lines always have an axis in common. One that is to replace another must be found at two
   * times in a row.
   */
  private boolean isConfirmed(long timeUs) {
    boolean confirmed =
        hasCandidate
            && timeUs - candidateUs <= 2e6 * settings.position().togetherS()
            && Math.abs(Vectors.dot(u, candidate)) > SAME_AXIS;
    System.arraycopy(u, 0, candidate, 0, 3);
    candidateUs = timeUs;
    hasCandidate = true;
    return confirmed;
  }

  /**
   * Whether an axis that was found anew points to the tail, by where the head last was for sure and
   * by where the body flies.
   */
  private boolean isAgainst() {
    position.velocity(tip);
    double speed = Math.max(1e-9, Vectors.length(tip));
    double sign = head.isFlipped() ? -1 : 1;
    return sign * Vectors.dot(u, tip) / speed + Vectors.dot(u, uAgreed) < 0;
  }

  private void loseAxis() {
    hasAxis = false;
    forgetDoubts();
  }

  private void forgetDoubts() {
    rejectedInstants = 0;
    agreements = 0;
    Arrays.fill(rejections, 0);
  }

  private OrientationEstimate estimate(long timeUs, double dtS, int taken, int rejected) {
    axis.axis(u);
    if (hasPlaceBefore && hadAxis) {
      double along = 0;
      for (int k = 0; k < 3; k++) {
        along += (place[k] - placeBefore[k]) * u[k];
      }
      head.step(along, position.variance(u), dtS);
    }
    if (!hadAxis || rejectedInstants == 0) {
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
        head.probability(),
        taken,
        rejected);
  }

  private AxisState predicted() {
    return axis instanceof SphereFilter sphere ? sphere.predictedState() : null;
  }

  private double[] transition() {
    return axis instanceof SphereFilter sphere ? sphere.transition() : null;
  }

  private AxisState current() {
    if (axis instanceof SphereFilter sphere) {
      return sphere.state();
    }
    double[] now = new double[3];
    axis.axis(now);
    return new AxisState(now, null, null, 0, 0, null);
  }

  /** Hands out each step of the axis and of the place, for a smoother; this allocates. */
  void record(Consumer<? super AxisStep> axisSteps, Consumer<? super FilterStep> placeSteps) {
    recorder = axisSteps;
    position.record(placeSteps);
  }

  private void count(OrientationCount what, long number) {
    counts[what.ordinal()] += number;
  }

  /**
   * How often something happened.
   *
   * @param what which
   * @return at least 0
   */
  public long count(OrientationCount what) {
    return counts[what.ordinal()];
  }

  /**
   * Standard deviation of a camera's angles, as set or as learnt so far.
   *
   * @param camera its index
   * @return radians
   */
  public double lineSdRad(int camera) {
    return Math.sqrt(lineVariances[camera]);
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

  /** State of the axis after the last instant; without a covariance if it is of quaternions. */
  AxisState axisState() {
    return current();
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
