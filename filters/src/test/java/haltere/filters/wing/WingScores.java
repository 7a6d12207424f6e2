package haltere.filters.wing;

import haltere.core.event.EventPacket;
import haltere.core.simulation.FlyScene;
import haltere.core.simulation.FlyTruth;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.filters.estimation.Angles;

/** Tracks a simulated fly and holds what the tracker says against the truth. */
final class WingScores implements WingListener {
  /** What comes sooner after the fly was found does not count. */
  static final long SETTLE_US = 300_000;

  private final FlyScene scene;
  final WingTracker tracker;
  long foundAtUs = -1;
  long events;
  long rows;
  int losses;
  FlyGeometry geometry;
  WingSnapshot lastSnapshot;
  private double angle;
  private double[] sideBias = new double[2];
  private double reversal;
  private long reversals;
  private double frequency;
  private double amplitude;
  private double amplitudeSum;
  private double phase;
  private final NormalisedErrors[] frequencyErrors = {
    new NormalisedErrors(), new NormalisedErrors()
  };
  private final NormalisedErrors[] angleErrors = {new NormalisedErrors(), new NormalisedErrors()};
  private double nis;
  private long beats;
  private double lag;
  private double centre;
  private double heading;
  private long geometries;
  long wrongUs;
  private long longestWrongUs;
  private boolean notFinite;
  double beatAmplitude;

  WingScores(FlyScene scene, WingTrackerSettings settings) {
    this.scene = scene;
    tracker = new WingTracker(scene.geometry(), settings, this);
  }

  /** Runs for a time of the scene. */
  WingScores run(double seconds) {
    run(scene, seconds, this);
    return this;
  }

  /** Runs several trackers on the same events for a time of their scene. */
  static void run(FlyScene scene, double seconds, WingScores... all) {
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
      // goes on until the end
    }
  }

  @Override
  public boolean wantsSnapshots() {
    return true;
  }

  @Override
  public void state(WingTrackerState state) {
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

  @Override
  public void geometry(FlyGeometry found) {
    geometry = found;
  }

  @Override
  public void snapshot(WingSnapshot snapshot) {
    lastSnapshot = snapshot;
    geometry = snapshot.geometry();
    if (counts(snapshot.timeUs())) {
      FlyTruth truth = scene.truthAt(snapshot.timeUs());
      double dx = geometry.centreX() - truth.centreXPx();
      double dy = geometry.centreY() - truth.centreYPx();
      centre += dx * dx + dy * dy;
      double turned = Angles.wrapPi(geometry.headingRad() - truth.headingRad());
      heading += turned * turned;
      geometries++;
      nis += tracker.meanNis();
    }
  }

  private static FlyTruth.Wing wing(FlyTruth truth, int side) {
    return side == 0 ? truth.left() : truth.right();
  }

  @Override
  public void estimate(WingEstimate e) {
    notFinite |=
        !Double.isFinite(e.angleRad() + e.centreRad() + e.amplitudeRad() + e.phaseRad())
            || !Double.isFinite(e.frequencyHz());
    if (e.edge() != WingPart.LEFT && e.edge() != WingPart.RIGHT || !counts(e.timeUs())) {
      return;
    }
    int side = e.edge() == WingPart.LEFT ? 0 : 1;
    FlyTruth.Wing truth = wing(scene.truthAt(e.timeUs()), side);
    double angleOff = Angles.wrapPi(e.angleRad() - truth.angleRad());
    double frequencyOff = e.frequencyHz() - truth.frequencyHz();
    double amplitudeOff = e.amplitudeRad() - truth.amplitudeRad();
    double phaseOff = Angles.wrapPi(e.phaseRad() - truth.phaseRad());
    rows++;
    angle += angleOff * angleOff;
    sideBias[side] += angleOff;
    frequency += frequencyOff * frequencyOff;
    amplitude += amplitudeOff * amplitudeOff;
    amplitudeSum += amplitudeOff;
    phase += phaseOff * phaseOff;
    frequencyErrors[side].add(frequencyOff / e.sdFrequencyHz());
    angleErrors[side].add(angleOff / e.sdAngleRad());
    if (Math.abs(Math.cos(truth.phaseRad())) < 0.2) {
      reversals++;
      reversal += angleOff * angleOff;
    }
    if (Math.abs(frequencyOff) > 0.3 * truth.frequencyHz()) {
      wrongUs += 1000;
      longestWrongUs = Math.max(longestWrongUs, wrongUs);
    } else {
      wrongUs = 0;
    }
  }

  @Override
  public void beat(WingBeat b) {
    if (!counts(b.timeUs())) {
      return;
    }
    FlyTruth truth = scene.truthAt(b.timeUs());
    double lagTruth = Angles.wrapPi(truth.left().phaseRad() - truth.right().phaseRad());
    double sign = b.side() == WingSide.LEFT ? -1 : 1;
    beats++;
    lag += square(Angles.wrapPi(b.phaseLagRad() - sign * lagTruth));
    beatAmplitude += square(b.amplitudeRad() - wing(truth, b.side().ordinal()).amplitudeRad());
  }

  private static double square(double value) {
    return value * value;
  }

  private static double rms(double squares, double count) {
    return Math.sqrt(squares / count);
  }

  double angleDeg() {
    return Math.toDegrees(rms(angle, rows));
  }

  /** Of the angles, without what the heading is off by: that counts for itself. */
  double angleOfStrokeDeg() {
    double turn = (sideBias[0] - sideBias[1]) / rows;
    return Math.toDegrees(Math.sqrt(Math.max(0, angle / rows - turn * turn)));
  }

  double reversalDeg() {
    return Math.toDegrees(rms(reversal, reversals));
  }

  double frequencyHz() {
    return rms(frequency, rows);
  }

  double amplitudeDeg() {
    return Math.toDegrees(rms(beatAmplitude, beats));
  }

  double amplitudeBiasDeg() {
    return Math.toDegrees(amplitudeSum / rows);
  }

  double phaseDeg() {
    return Math.toDegrees(rms(phase, rows));
  }

  double lagDeg() {
    return Math.toDegrees(rms(lag, beats));
  }

  double centrePx() {
    return rms(centre, geometries);
  }

  double headingDeg() {
    return Math.toDegrees(rms(heading, geometries));
  }

  double meanNis() {
    return nis / geometries;
  }

  double neesFrequency() {
    return NormalisedErrors.meanSquare(frequencyErrors);
  }

  double neesAngle() {
    return NormalisedErrors.meanSquare(angleErrors);
  }

  /** Normalised errors of the frequency of each wing. */
  NormalisedErrors[] frequencyErrors() {
    return frequencyErrors;
  }

  /** Normalised errors of the angle of each wing. */
  NormalisedErrors[] angleErrors() {
    return angleErrors;
  }

  long longestWrongUs() {
    return longestWrongUs;
  }

  boolean isFinite() {
    return !notFinite;
  }
}
