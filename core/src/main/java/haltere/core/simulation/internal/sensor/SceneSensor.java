package haltere.core.simulation.internal.sensor;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.simulation.RunSettings;
import java.util.function.Function;

/**
 * The sensor of a scene: pixels, noise and the bus of their events. A scene changes the light of
 * the {@link #pixels()}, ends each interval and takes its events.
 *
 * <p>Thread rule: one thread at a time.
 *
 * @param <P> the model of its pixels
 */
public final class SceneSensor<P extends SensorPixels> {
  private final SensorSettings settings;
  private final long seed;
  private final SensorGeometry geometry;
  private final EventMerger bus;
  private final P pixels;
  private BackgroundNoise noise;
  private SensorTuning tuning;

  /**
   * A sensor in the dark.
   *
   * @param pixel what its pixels are like
   * @param noise background noise
   * @param settings its size and its bus
   * @param run seed and start of the clock
   * @param model makes the pixels before a bus
   */
  public SceneSensor(
      PixelSettings pixel,
      NoiseSettings noise,
      SensorSettings settings,
      RunSettings run,
      Function<EventMerger, P> model) {
    this.settings = settings;
    seed = run.seed();
    geometry = new SensorGeometry(settings.widthPx(), settings.heightPx());
    tuning = new SensorTuning(pixel, noise, 0);
    bus = new EventMerger(pixel, settings, run);
    pixels = model.apply(bus);
    this.noise = new BackgroundNoise(noise, settings, seed);
  }

  /**
   * A sensor in the dark, of pixels that low-pass the logarithm of the light.
   *
   * @param pixel what its pixels are like
   * @param noise background noise
   * @param settings its size and its bus
   * @param run seed and start of the clock
   * @return a sensor with a {@link PixelArray}
   */
  public static SceneSensor<PixelArray> of(
      PixelSettings pixel, NoiseSettings noise, SensorSettings settings, RunSettings run) {
    return new SceneSensor<>(
        pixel, noise, settings, run, bus -> new PixelArray(pixel, settings, run.seed(), bus));
  }

  /**
   * The size of the sensor.
   *
   * @return columns and rows
   */
  public SensorGeometry geometry() {
    return geometry;
  }

  /**
   * The pixels.
   *
   * @return to change their light
   */
  public P pixels() {
    return pixels;
  }

  /**
   * The bus, for events that no pixel's light causes, such as those of rain.
   *
   * @return the bus
   */
  public EventMerger bus() {
    return bus;
  }

  /**
   * The tuning in effect.
   *
   * @return the last tuning
   */
  public SensorTuning tuning() {
    return tuning;
  }

  /**
   * Tunes it while it runs.
   *
   * @param newTuning in effect from this time on
   * @param timeUs time of the scene, microseconds from its start
   */
  public void tune(SensorTuning newTuning, long timeUs) {
    pixels.tune(newTuning.pixel(), newTuning.balance(), timeUs);
    bus.tune(newTuning.pixel());
    if (!newTuning.noise().equals(tuning.noise())) {
      noise = new BackgroundNoise(newTuning.noise(), settings, seed, timeUs);
    }
    tuning = newTuning;
  }

  /**
   * Advances all pixels and the noise to a time, after the changes of the scene.
   *
   * @param timeUs microseconds from the scene's start
   */
  public void advance(long timeUs) {
    pixels.advanceAll(timeUs);
    noise.addUntil(timeUs, bus);
  }

  /**
   * Releases the events before a time.
   *
   * @param timeUs microseconds from the scene's start
   * @param out gets them, in order
   */
  public void release(long timeUs, EventPacket out) {
    bus.release(timeUs, out);
  }
}
