package haltere.core.simulation.internal.road;

import haltere.core.event.EventPacket;
import haltere.core.simulation.internal.sensor.PixelArray;
import haltere.core.simulation.internal.sensor.SceneSensor;
import haltere.core.simulation.internal.sensor.SensorScene;
import java.util.List;

/**
 * Traffic on a road, seen by a dynamic vision sensor on a bridge: a test bed for trackers and for
 * maps from pixels to metres, with ground truth.
 *
 * <p>The camera's angle below the horizon is linear in the row, from the bottom row to that of the
 * vanishing point, and a pixel subtends the same angle across. Vehicles are made of painted boxes
 * that keep to their lanes, cruise, overtake, stop and start, slow down, or ride side by side, at
 * exact speeds, and never touch. A nearer vehicle hides a farther one. Their edges and what is
 * painted on them (windows, lamps, tyres) change the light of a pixel when they pass its centre;
 * the pixels ({@code PixelArray}), latency, jitter, noise and rain are as the settings say.
 *
 * <p>The same settings make the same events, bit for bit, on every machine. The stream is made as
 * it is pulled, in constant memory, and ends only if the settings give it a length. Truth is a pure
 * function of time; see {@link RoadTruth}.
 *
 * <p>Thread rule: pulled by one thread at a time; the truth may be queried by any thread.
 */
public final class RoadScene extends SensorScene<RoadTruth> {
  private static final int INTERVAL_US = 4000;

  private final RoadSceneSettings settings;
  private final RoadCamera camera;
  private final RoadTruthRows truth;
  private final RoadPainter painter;
  private final RainStreaks rain;

  /**
   * A scene at its beginning.
   *
   * @param settings of the scene
   */
  public RoadScene(RoadSceneSettings settings) {
    this(settings, MAX_EVENTS);
  }

  /** A scene with a maximum number of events per packet. */
  RoadScene(RoadSceneSettings settings, int maxEvents) {
    this(
        settings,
        maxEvents,
        SceneSensor.of(settings.pixel(), settings.noise(), settings.sensor(), settings.run()));
  }

  private RoadScene(RoadSceneSettings settings, int maxEvents, SceneSensor<PixelArray> sensor) {
    super("road", sensor, settings.run(), maxEvents);
    this.settings = settings;
    camera = new RoadCamera(settings.camera(), settings.sensor());
    TrafficPlan plan = new TrafficPlan(settings);
    truth = new RoadTruthRows(settings, camera, plan);
    painter = new RoadPainter(settings, camera, plan, sensor.pixels());
    rain = new RainStreaks(settings.rain(), settings.sensor(), settings.run().seed());
    painter.begin();
  }

  /**
   * The settings of the scene.
   *
   * @return as given
   */
  public RoadSceneSettings settings() {
    return settings;
  }

  /**
   * Column of the vanishing point.
   *
   * @return pixels to the right
   */
  public double vanishingXPx() {
    return camera.vanishingXPx;
  }

  /**
   * Row of the vanishing point.
   *
   * @return pixels up
   */
  public double vanishingYPx() {
    return camera.vanishingYPx;
  }

  @Override
  public Class<RoadTruth> truthType() {
    return RoadTruth.class;
  }

  @Override
  public List<RoadTruth> truthRows(long timeUs) {
    return truth.rows(timeUs);
  }

  @Override
  protected long makeInterval(long fromUs, SceneSensor<?> sensor, EventPacket out) {
    long untilUs = fromUs + INTERVAL_US;
    painter.paint(fromUs, untilUs);
    sensor.advance(untilUs);
    rain.addUntil(untilUs, sensor.bus());
    sensor.release(untilUs, out);
    return untilUs;
  }
}
