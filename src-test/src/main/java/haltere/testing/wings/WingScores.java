package haltere.testing.wings;

import haltere.core.event.EventPacket;
import haltere.core.simulation.internal.fly.FlyTruth;
import haltere.core.simulation.internal.sensor.SensorScene;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.filters.estimation.Angles;
import haltere.filters.wing.FlyGeometry;
import haltere.filters.wing.WingBeat;
import haltere.filters.wing.WingEstimate;
import haltere.filters.wing.WingListener;
import haltere.filters.wing.WingPart;
import haltere.filters.wing.WingResult;
import haltere.filters.wing.WingSnapshot;
import haltere.filters.wing.WingTrackerSettings;
import haltere.filters.wing.WingTrackerState;
import haltere.filters.wing.tracker.WingTracker;
import java.util.Arrays;

/**
 * Tracks a simulated fly and compares the results with the truth, from 0.3 s after the fly was
 * found.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class WingScores implements WingListener {
  private static final long SETTLE_US = 300_000;

  /** A frequency that is off by more than this share is on a wrong multiple of the beat. */
  private static final double WRONG_SHARE = 0.3;

  /** A frequency on a wrong multiple for longer than this is not locked. */
  private static final long LONG_WRONG_US = 50_000;

  /** Cosine of the phase within which a wing is at its reversal. */
  private static final double REVERSAL = 0.2;

  private SensorScene<FlyTruth> scene;
  private WingTracker tracker;
  private final long tickUs;
  private long foundAtUs = -1;
  private long events;
  private int losses;
  private FlyGeometry geometry;
  private final RootMeanSquare angle = new RootMeanSquare();
  private final RootMeanSquare reversal = new RootMeanSquare();
  private final RootMeanSquare frequency = new RootMeanSquare();
  private final RootMeanSquare beatAmplitude = new RootMeanSquare();
  private final RootMeanSquare lag = new RootMeanSquare();
  private final RootMeanSquare centre = new RootMeanSquare();
  private final RootMeanSquare heading = new RootMeanSquare();
  private final RootMeanSquare statedAngle = new RootMeanSquare();
  private final RootMeanSquare statedFrequency = new RootMeanSquare();
  private final PhaseErrors[] phaseErrors = new PhaseErrors[WingPart.values().length];
  private final double[] angleSum = new double[2];
  private double amplitudeSum;
  private long rows;
  private double nis;
  private long snapshots;
  private final NormalisedErrors[] frequencyErrors = {
    new NormalisedErrors(), new NormalisedErrors()
  };
  private final NormalisedErrors[] angleErrors = {new NormalisedErrors(), new NormalisedErrors()};
  private final long[] wrongUs = new long[2];
  private long longestWrongUs;

  /**
   * Scores that have seen nothing.
   *
   * @param scene whose truth counts
   * @param settings of the tracker
   */
  public WingScores(SensorScene<FlyTruth> scene, WingTrackerSettings settings) {
    this.scene = scene;
    tracker = new WingTracker(scene.geometry(), settings, this);
    tickUs = Math.round(1e6 / settings.output().rateHz());
    Arrays.setAll(phaseErrors, part -> new PhaseErrors());
  }

  /**
   * Runs for a time of the scene, once.
   *
   * @param seconds from the beginning of the scene
   * @return these scores
   */
  public WingScores run(double seconds) {
    run(scene, seconds, this);
    return this;
  }

  /**
   * Runs several trackers on the same events, once. Scene and trackers are let go afterwards, so
   * that thousands of scores fit into memory.
   *
   * @param scene of all of them
   * @param seconds from the beginning of the scene
   * @param all scores of that scene
   */
  public static void run(SensorScene<FlyTruth> scene, double seconds, WingScores... all) {
    long endUs = scene.startUs() + Math.round(seconds * 1e6);
    boolean[] ended = {false};
    StreamHandler handler =
        new StreamHandler() {
          @Override
          public void packet(EventPacket packet) {
            if (packet.isEmpty() || packet.firstTimeUs() >= endUs) {
              ended[0] = !packet.isEmpty();
              return;
            }
            for (WingScores scores : all) {
              scores.events += packet.size();
              scores.tracker.track(packet);
            }
          }

          @Override
          public void notified(StreamNotification notification) {
            // nothing to do
          }
        };
    while (!ended[0] && scene.next(handler)) {
      // continues until the end
    }
    for (WingScores scores : all) {
      scores.scene = null;
      scores.tracker = null;
    }
  }

  @Override
  public boolean isRequested(Class<? extends WingResult> kind) {
    return kind == WingEstimate.class || kind == WingSnapshot.class;
  }

  @Override
  public void accept(WingResult result) {
    if (result instanceof WingEstimate estimate) {
      estimate(estimate);
    } else if (result instanceof WingSnapshot snapshot) {
      snapshot(snapshot);
    } else if (result instanceof WingBeat beat) {
      beat(beat);
    } else if (result instanceof WingTrackerState state) {
      state(state);
    } else if (result instanceof FlyGeometry found) {
      geometry = found;
    }
  }

  private void state(WingTrackerState state) {
    switch (state.phase()) {
      case TRACKING -> foundAtUs = foundAtUs < 0 ? state.timeUs() : foundAtUs;
      case LOST, ONE_WING -> losses += foundAtUs < 0 ? 0 : 1;
      default -> {
        // a step on the way
      }
    }
  }

  private boolean counts(long timeUs) {
    return foundAtUs >= 0 && timeUs >= foundAtUs + SETTLE_US;
  }

  private void snapshot(WingSnapshot snapshot) {
    geometry = snapshot.geometry();
    if (!counts(snapshot.timeUs())) {
      return;
    }
    FlyTruth truth = truthAt(snapshot.timeUs());
    double dx = geometry.centreX() - truth.centreXPx();
    double dy = geometry.centreY() - truth.centreYPx();
    centre.addSquare(dx * dx + dy * dy);
    heading.add(Angles.wrapPi(geometry.headingRad() - truth.headingRad()));
    nis += tracker.meanNis();
    snapshots++;
  }

  private FlyTruth truthAt(long timeUs) {
    return scene.truthRows(timeUs).get(0);
  }

  private static FlyTruth.Wing wing(FlyTruth truth, int side) {
    return side == 0 ? truth.left() : truth.right();
  }

  private static double truthOf(FlyTruth.Wing truth, WingPart part) {
    return switch (part) {
      case LEFT_LEADING, RIGHT_LEADING -> truth.leadingRad();
      case LEFT_TRAILING, RIGHT_TRAILING -> truth.trailingRad();
      default -> truth.angleRad();
    };
  }

  private void estimate(WingEstimate e) {
    if (!counts(e.timeUs())) {
      return;
    }
    int side = e.edge().sideNumber();
    FlyTruth.Wing truth = wing(truthAt(e.timeUs()), side);
    double angleOff = Angles.wrapPi(e.angleRad() - truthOf(truth, e.edge()));
    phaseErrors[e.edge().ordinal()].add(truth.phaseRad(), angleOff);
    if (e.edge() != WingPart.LEFT && e.edge() != WingPart.RIGHT) {
      return;
    }
    double frequencyOff = e.frequencyHz() - truth.frequencyHz();
    rows++;
    angle.add(angleOff);
    angleSum[side] += angleOff;
    statedAngle.add(e.sdAngleRad());
    statedFrequency.add(e.sdFrequencyHz());
    frequency.add(frequencyOff);
    amplitudeSum += e.amplitudeRad() - truth.amplitudeRad();
    frequencyErrors[side].add(frequencyOff / e.sdFrequencyHz());
    angleErrors[side].add(angleOff / e.sdAngleRad());
    if (Math.abs(Math.cos(truth.phaseRad())) < REVERSAL) {
      reversal.add(angleOff);
    }
    boolean wrong = Math.abs(frequencyOff) > WRONG_SHARE * truth.frequencyHz();
    wrongUs[side] = wrong ? wrongUs[side] + tickUs : 0;
    longestWrongUs = Math.max(longestWrongUs, wrongUs[side]);
  }

  private void beat(WingBeat b) {
    if (!counts(b.timeUs())) {
      return;
    }
    FlyTruth truth = truthAt(b.timeUs());
    double lagTruth = Angles.wrapPi(truth.left().phaseRad() - truth.right().phaseRad());
    double sign = b.side() == WingPart.LEFT ? -1 : 1;
    lag.add(Angles.wrapPi(b.phaseLagRad() - sign * lagTruth));
    beatAmplitude.add(b.amplitudeRad() - wing(truth, b.side().sideNumber()).amplitudeRad());
  }

  /**
   * When both wings were first tracked.
   *
   * @return microseconds on the clock of the events; -1 if never
   */
  public long foundAtUs() {
    return foundAtUs;
  }

  /**
   * Whether both wings were found, kept, and never on a wrong multiple of the beat for long.
   *
   * @return false if any of that failed
   */
  public boolean isLocked() {
    return foundAtUs >= 0 && losses == 0 && longestWrongUs <= LONG_WRONG_US;
  }

  /**
   * How often one or both wings were lost after that.
   *
   * @return a count
   */
  public int losses() {
    return losses;
  }

  /**
   * Events that were tracked.
   *
   * @return a count
   */
  public long events() {
    return events;
  }

  /**
   * The last estimated geometry of the fly.
   *
   * @return null if it was never found
   */
  public FlyGeometry geometry() {
    return geometry;
  }

  /**
   * Longest time for which a frequency was on a wrong multiple of the beat.
   *
   * @return microseconds
   */
  public long longestWrongUs() {
    return longestWrongUs;
  }

  /**
   * Error of the wings' angle.
   *
   * @return RMS over time, degrees
   */
  public double angleDeg() {
    return angle.degrees();
  }

  /**
   * Error of the wings' angle without what the heading is off by, which counts for itself.
   *
   * @return RMS over time, degrees
   */
  public double angleOfStrokeDeg() {
    double turn = (angleSum[0] - angleSum[1]) / rows;
    double all = angle.value();
    return Math.toDegrees(Math.sqrt(Math.max(0, all * all - turn * turn)));
  }

  /**
   * Standard deviation of the wings' angle as the tracker states it.
   *
   * @return RMS over time, degrees
   */
  public double statedAngleDeg() {
    return statedAngle.degrees();
  }

  /**
   * Standard deviation of the frequency as the tracker states it.
   *
   * @return RMS over time, hertz
   */
  public double statedFrequencyHz() {
    return statedFrequency.value();
  }

  /** Errors of the angle of a wing or an edge over the phase of the stroke. */
  PhaseErrors phaseErrors(WingPart part) {
    return phaseErrors[part.ordinal()];
  }

  /**
   * Error of the wings' angle at the reversals.
   *
   * @return RMS over time, degrees
   */
  public double reversalDeg() {
    return reversal.degrees();
  }

  /**
   * Error of the frequency.
   *
   * @return RMS over time, hertz
   */
  public double frequencyHz() {
    return frequency.value();
  }

  /**
   * Error of the amplitude of a beat.
   *
   * @return RMS over beats, degrees
   */
  public double amplitudeDeg() {
    return beatAmplitude.degrees();
  }

  /**
   * Mean error of the amplitude.
   *
   * @return degrees, positive where it is too large
   */
  public double amplitudeBiasDeg() {
    return Math.toDegrees(amplitudeSum / rows);
  }

  /**
   * Error of how far one wing is behind the other.
   *
   * @return RMS over beats, degrees of phase
   */
  public double lagDeg() {
    return lag.degrees();
  }

  /**
   * Error of the body's centre.
   *
   * @return RMS over time, pixels
   */
  public double centrePx() {
    return centre.value();
  }

  /**
   * Error of the heading.
   *
   * @return RMS over time, degrees
   */
  public double headingDeg() {
    return heading.degrees();
  }

  /**
   * Mean normalised innovation squared.
   *
   * @return 1 if the filters know how good their measurements are
   */
  public double meanNis() {
    return nis / snapshots;
  }

  /**
   * Mean square of the frequency's error over its standard deviation (NEES).
   *
   * @return 1 if the standard deviations are right
   */
  public double neesFrequency() {
    return NormalisedErrors.meanSquare(frequencyErrors);
  }

  /**
   * Mean square of the angle's error over its standard deviation (NEES).
   *
   * @return 1 if the standard deviations are right
   */
  public double neesAngle() {
    return NormalisedErrors.meanSquare(angleErrors);
  }

  /** Errors of the frequency of each wing, divided by their standard deviations. */
  NormalisedErrors[] frequencyErrors() {
    return frequencyErrors;
  }

  /** Errors of the angle of each wing, divided by their standard deviations. */
  NormalisedErrors[] angleErrors() {
    return angleErrors;
  }
}
