package haltere.core.simulation.internal.fly;

import haltere.core.simulation.internal.sensor.SeededRandom;
import haltere.core.simulation.internal.sensor.SensorSettings;
import haltere.core.simulation.internal.sensor.SlowProcess;

/**
 * The motion of the fly as a pure function of time: position and heading of the body; frequency,
 * phase (the integral of that frequency), amplitude and centre of each wing. The stroke angle is
 * centre + amplitude * waveform(phase).
 *
 * <p>Thread rule: immutable.
 */
final class FlyKinematics {
  static final int LEFT = 0;
  static final int RIGHT = 1;

  /** Smallest angle between a wing and the rear midline in a clap, radians. */
  static final double CLAP_GAP = 0.02;

  private final SensorSettings sensor;
  private final BodySettings body;
  private final StrokeSettings stroke;
  private final ManoeuvreSettings manoeuvre;
  private final BeatSettings beat;
  private final Waveform waveform;
  private final Manoeuvres manoeuvres;
  private final SlowProcess frequency;
  private final SlowProcess[] amplitude = new SlowProcess[2];
  private final SlowProcess[] wobble = new SlowProcess[3];
  private final SlowProcess[] drift = new SlowProcess[2];
  private final double firstCycles;

  FlyKinematics(
      SensorSettings sensor,
      BodySettings body,
      StrokeSettings stroke,
      ManoeuvreSettings manoeuvre,
      long seed) {
    this.sensor = sensor;
    this.body = body;
    this.stroke = stroke;
    this.manoeuvre = manoeuvre;
    beat = stroke.beat();
    waveform = beat.waveform().normalised(beat.harmonics());
    manoeuvres = new Manoeuvres(manoeuvre, seed);
    double slowest = 0.05 / beat.timescaleS();
    double fastest = 1 / beat.timescaleS();
    frequency =
        new SlowProcess(
            new SeededRandom(seed, "frequency"), beat.frequencySdHz(), slowest, fastest);
    for (int side = LEFT; side <= RIGHT; side++) {
      amplitude[side] =
          new SlowProcess(
              new SeededRandom(seed, "amplitude " + side), beat.amplitudeSdRad(), slowest, fastest);
      drift[side] =
          new SlowProcess(new SeededRandom(seed, "drift " + side), body.driftPx(), 0.02, 0.2);
    }
    double[] wobbleSd = {body.wobblePx(), body.wobblePx(), body.wobblePx() / body.lengthPx()};
    for (int axis = 0; axis < wobble.length; axis++) {
      wobble[axis] =
          new SlowProcess(new SeededRandom(seed, "wobble " + axis), wobbleSd[axis], 1, 8);
    }
    firstCycles = new SeededRandom(seed, "first phase").nextDouble();
  }

  private WingStrokeSettings wing(int side) {
    return side == LEFT ? stroke.left() : stroke.right();
  }

  /** The shape of the stroke, centre 0, half of peak to peak 1, rising through 0 at phase 0. */
  Waveform waveform() {
    return waveform;
  }

  /**
   * Fills a pose.
   *
   * @param seconds time since the beginning of the scene
   * @param pose is overwritten
   */
  void sample(double seconds, FlyPose pose) {
    pose.centreX =
        (sensor.widthPx() - 1) / 2.0
            + body.offsetXPx()
            + wobble[0].at(seconds)
            + drift[0].at(seconds);
    pose.centreY =
        (sensor.heightPx() - 1) / 2.0
            + body.offsetYPx()
            + wobble[1].at(seconds)
            + drift[1].at(seconds);
    pose.heading = body.headingRad() + wobble[2].at(seconds) + manoeuvres.turnRad(seconds);
    pose.cosHeading = StrictMath.cos(pose.heading);
    pose.sinHeading = StrictMath.sin(pose.heading);
    double commonHz = beat.frequencyHz() + frequency.at(seconds) + manoeuvres.frequencyHz(seconds);
    double commonCycles =
        firstCycles
            + beat.frequencyHz() * seconds
            + frequency.integralTo(seconds)
            + manoeuvres.cycles(seconds);
    double asymmetry = manoeuvres.asymmetryRad(seconds) / 2;
    for (int side = LEFT; side <= RIGHT; side++) {
      WingStrokeSettings wing = wing(side);
      double outwards = side == LEFT ? body.hingeOffsetPx() : -body.hingeOffsetPx();
      pose.hingeX[side] = pose.centreX - outwards * pose.sinHeading;
      pose.hingeY[side] = pose.centreY + outwards * pose.cosHeading;
      pose.frequencyHz[side] = commonHz + wing.frequencyOffsetHz();
      pose.cycles[side] =
          commonCycles + wing.frequencyOffsetHz() * seconds - wing.phaseLagRad() / (2 * Math.PI);
      double half =
          wing.amplitudeRad()
              + amplitude[side].at(seconds)
              + (side == LEFT ? asymmetry : -asymmetry);
      pose.amplitude[side] = Math.max(0, half);
      pose.centre[side] =
          beat.clapAndFling()
              ? Math.PI - CLAP_GAP - pose.amplitude[side] * waveform.max()
              : wing.centreRad();
    }
  }

  /** Lower bound of the stroke angle. */
  double minAngle(int side) {
    double half = maxAmplitude(side);
    return beat.clapAndFling()
        ? Math.PI - CLAP_GAP + half * (waveform.min() - waveform.max())
        : wing(side).centreRad() + half * waveform.min();
  }

  /** Upper bound of the stroke angle. */
  double maxAngle(int side) {
    return beat.clapAndFling()
        ? Math.PI - CLAP_GAP
        : wing(side).centreRad() + maxAmplitude(side) * waveform.max();
  }

  private double maxAmplitude(int side) {
    return wing(side).amplitudeRad() + amplitude[side].bound() + manoeuvre.asymmetryRad() / 2;
  }

  /** Stroke angle of a wing from its parameters. */
  double angle(double centre, double amplitude, double cycles) {
    return centre + amplitude * waveform.at(2 * Math.PI * (cycles - Math.floor(cycles)));
  }
}
