package haltere.core.simulation.internal.fly;

import haltere.core.simulation.internal.sensor.EventMerger;
import haltere.core.simulation.internal.sensor.PixelArray;
import haltere.core.simulation.internal.sensor.SceneSensor;

/**
 * A tethered fruit fly in front of a bright background, seen by a dynamic vision sensor: a test bed
 * for wing trackers with ground truth.
 *
 * <p>Each wing is a dark sector about its hinge that beats with a published stroke waveform ({@link
 * StrokeWaveform}); frequency and amplitude vary smoothly and at seeded times the fly manoeuvres.
 * The leading edge darkens pixels (OFF), the trailing edge brightens them (ON). The pixels ({@code
 * PixelArray}) are solved exactly for every passage of an edge: the photoreceptor reduces and
 * delays the events of fast edges in mid stroke; events are densest at the reversals. The body's
 * outline flickers as the body sways. Latency, jitter, threshold mismatch, refractory period,
 * noise, hot pixels and the limit of the bus are as the settings say.
 *
 * <p>The same settings make the same events, bit for bit, on every machine. The stream is made as
 * it is pulled, in constant memory, and ends only if the settings give it a length. Truth is a pure
 * function of time: {@link #truthAt}.
 *
 * <p>Thread rule: pulled by one thread at a time; {@link #truthAt} may be called by any thread.
 */
public final class FlyScene extends TetheredFlyScene {
  private static final int STEP_US = 10;
  private static final int STRETCH_US = 200;
  private static final int LOOKS = 10;

  private final FlySceneSettings settings;
  private final EventMerger bus;
  private final WingSweep[] wings = new WingSweep[2];
  private final BodyOutline outline;

  /**
   * A scene at its beginning.
   *
   * @param settings of the scene
   */
  public FlyScene(FlySceneSettings settings) {
    this(settings, MAX_EVENTS);
  }

  /** A scene with a maximum number of events per packet. */
  FlyScene(FlySceneSettings settings, int maxEvents) {
    this(
        settings,
        maxEvents,
        SceneSensor.of(settings.pixel(), settings.noise(), settings.sensor(), settings.run()));
  }

  private FlyScene(FlySceneSettings settings, int maxEvents, SceneSensor<PixelArray> sensor) {
    super(
        "fly",
        sensor,
        settings.run(),
        maxEvents,
        new FlyKinematics(
            settings.sensor(),
            settings.fly().body(),
            settings.stroke(),
            settings.disturbances().manoeuvres(),
            settings.run().seed()),
        STRETCH_US);
    this.settings = settings;
    bus = sensor.bus();
    PixelArray pixels = sensor.pixels();
    WireMask wire = new WireMask(settings.disturbances().wire(), settings.sensor());
    BodyShape shape = new BodyShape(settings.fly().body().lengthPx());
    outline = new BodyOutline(settings, shape, pixels, wire, kinematics, LOOKS);
    for (int side = 0; side < wings.length; side++) {
      wings[side] = new WingSweep(side, settings, kinematics, pixels, shape, wire);
      wings[side].place(before, angle(side, before, after, 0));
    }
    pixels.settleAll();
  }

  /**
   * The settings of the scene.
   *
   * @return as given
   */
  public FlySceneSettings settings() {
    return settings;
  }

  /**
   * Events that the bus did not carry, up to now.
   *
   * @return at least 0
   */
  public long lostOnBus() {
    return bus.lost();
  }

  @Override
  FlyTruth.Wing wing(FlyPose pose, int side) {
    return FlyTruth.Wing.of(pose, side, kinematics.waveform(), settings.fly().wing().widthRad());
  }

  @Override
  void makeStretch(long fromUs) {
    long doneUs = fromUs + STRETCH_US;
    for (int side = 0; side < 2; side++) {
      for (int step = STEP_US; step <= STRETCH_US; step += STEP_US) {
        double untilUs = fromUs + step;
        wings[side].sweepTo(
            angle(side, before, after, (double) step / STRETCH_US), untilUs - STEP_US, untilUs);
      }
      wings[side].bodyMoved(after, doneUs);
    }
    outline.look((int) (fromUs / STRETCH_US % LOOKS), fromUs, STRETCH_US, after);
  }
}
