package haltere.core.simulation.internal.fly;

import haltere.core.event.EventPacket;
import haltere.core.simulation.RunSettings;
import haltere.core.simulation.internal.sensor.SceneSensor;
import haltere.core.simulation.internal.sensor.SensorScene;
import java.util.List;

/** A tethered fly as a scene: its motion, made stretch by stretch, and its truth. */
abstract class TetheredFlyScene extends SensorScene<FlyTruth> {
  static final double US = 1e-6;
  private static final int INTERVAL_US = 1000;

  final FlyKinematics kinematics;

  /** The poses at the beginning and at the end of the present stretch. */
  FlyPose before = new FlyPose();

  FlyPose after = new FlyPose();
  private final int stretchUs;

  /** A scene at its beginning; an interval of a millisecond is a whole number of stretches. */
  TetheredFlyScene(
      String name,
      SceneSensor<?> sensor,
      RunSettings run,
      int maxEvents,
      FlyKinematics kinematics,
      int stretchUs) {
    super(name, sensor, run, maxEvents);
    this.kinematics = kinematics;
    this.stretchUs = stretchUs;
    kinematics.sample(0, before);
  }

  /** Makes the events from the pose before to the pose after. */
  abstract void makeStretch(long fromUs);

  /** The truth about a wing in a pose. */
  abstract FlyTruth.Wing wing(FlyPose pose, int side);

  /**
   * The truth at a time.
   *
   * @param timeUs microseconds on the clock of the events
   * @return one row
   */
  public final FlyTruth truthAt(long timeUs) {
    FlyPose pose = new FlyPose();
    kinematics.sample((timeUs - startUs()) * US, pose);
    return FlyTruth.of(
        timeUs, pose, wing(pose, FlyKinematics.LEFT), wing(pose, FlyKinematics.RIGHT));
  }

  @Override
  public final Class<FlyTruth> truthType() {
    return FlyTruth.class;
  }

  @Override
  public final List<FlyTruth> truthRows(long timeUs) {
    return List.of(truthAt(timeUs));
  }

  @Override
  protected final long makeInterval(long fromUs, SceneSensor<?> sensor, EventPacket out) {
    for (long doneUs = fromUs; doneUs < fromUs + INTERVAL_US; doneUs += stretchUs) {
      kinematics.sample((doneUs + stretchUs) * US, after);
      makeStretch(doneUs);
      FlyPose swap = before;
      before = after;
      after = swap;
    }
    sensor.advance(fromUs + INTERVAL_US);
    sensor.release(fromUs + INTERVAL_US, out);
    return fromUs + INTERVAL_US;
  }

  static double between(double from, double to, double share) {
    return from + share * (to - from);
  }

  /** Stroke angle at a fraction of the interval between two poses. */
  final double angle(int side, FlyPose one, FlyPose next, double share) {
    return kinematics.angle(
        between(one.centre[side], next.centre[side], share),
        between(one.amplitude[side], next.amplitude[side], share),
        between(one.cycles[side], next.cycles[side], share));
  }
}
