package haltere.core.simulation.internal.dots;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.simulation.RunSettings;
import haltere.core.simulation.Scene;
import haltere.core.simulation.internal.sensor.BackgroundNoise;
import haltere.core.simulation.internal.sensor.EventMerger;
import haltere.core.simulation.internal.sensor.PacketCutter;
import haltere.core.simulation.internal.sensor.PixelSettings;
import haltere.core.simulation.internal.sensor.SeededRandom;
import haltere.core.simulation.internal.sensor.SensorSettings;
import haltere.core.stream.StreamHandler;
import java.util.ArrayList;
import java.util.List;

/**
 * Dark discs on known paths through noise: the simplest scene for cluster trackers. The front edge
 * makes OFF events, the rear edge ON events, at random times and random positions along the edge,
 * in proportion to the pixels that are swept; a pixel has neither latency nor memory.
 *
 * <p>The same settings make the same events, bit for bit. Thread rule: pulled by one thread at a
 * time; the truth may be queried by any thread.
 */
public final class MovingDotsScene implements Scene<DotTruth> {
  private static final int MAX_EVENTS = 4096;
  private static final int INTERVAL_US = 1000;

  private final MovingDotsSettings settings;
  private final SensorGeometry geometry;
  private final DotMotion[] motions;
  private final SeededRandom random;
  private final double eventsPerUs;
  private final EventMerger merger;
  private final BackgroundNoise noise;
  private final PacketCutter cutter;
  private double nextUs;
  private long doneUs;

  /**
   * A scene at its beginning.
   *
   * @param settings of the scene
   */
  public MovingDotsScene(MovingDotsSettings settings) {
    this.settings = settings;
    SensorSettings sensor = settings.sensor();
    DotSettings dots = settings.dots();
    geometry = new SensorGeometry(sensor.widthPx(), sensor.heightPx());
    motions = new DotMotion[dots.count()];
    for (int i = 0; i < motions.length; i++) {
      motions[i] = new DotMotion(dots, sensor, i);
    }
    random = new SeededRandom(settings.run().seed(), "dots");
    double sweptPerDot = 2 * 2 * dots.radiusPx() * dots.speedPxS();
    eventsPerUs = sweptPerDot * dots.eventsPerPixel() * dots.count() * 1e-6;
    nextUs = pause();
    merger = new EventMerger(new PixelSettings(1, 0, 0, 0, 0, 0, 0), sensor, settings.run());
    noise = new BackgroundNoise(settings.noise(), sensor, settings.run().seed());
    cutter =
        new PacketCutter(settings.run(), geometry, "moving dots", MAX_EVENTS, this::makeInterval);
  }

  @Override
  public SensorGeometry geometry() {
    return geometry;
  }

  @Override
  public boolean next(StreamHandler handler) {
    return cutter.next(handler);
  }

  @Override
  public Class<DotTruth> truthType() {
    return DotTruth.class;
  }

  @Override
  public List<DotTruth> truthRows(long timeUs) {
    double seconds = (timeUs - startUs()) * 1e-6;
    List<DotTruth> rows = new ArrayList<>(motions.length);
    for (int i = 0; i < motions.length; i++) {
      DotMotion motion = motions[i];
      rows.add(
          new DotTruth(
              timeUs,
              i,
              motion.x(seconds),
              motion.y(seconds),
              motion.velocityX(seconds),
              motion.velocityY(seconds),
              settings.dots().radiusPx()));
    }
    return rows;
  }

  @Override
  public RunSettings run() {
    return settings.run();
  }

  private double pause() {
    return eventsPerUs == 0 ? Double.POSITIVE_INFINITY : random.exponential() / eventsPerUs;
  }

  private long makeInterval(EventPacket out) {
    doneUs += INTERVAL_US;
    while (nextUs < doneUs) {
      addEvent(motions[random.below(motions.length)], nextUs * 1e-6);
      nextUs += pause();
    }
    noise.addUntil(doneUs, merger);
    merger.release(doneUs, out);
    return doneUs;
  }

  private void addEvent(DotMotion motion, double seconds) {
    double radius = settings.dots().radiusPx();
    boolean on = (random.nextLong() & 1) != 0;
    double across = random.between(-radius, radius);
    double ahead = Math.sqrt(radius * radius - across * across);
    if (on) {
      ahead = -ahead;
    }
    double speed = settings.dots().speedPxS();
    double cos = motion.velocityX(seconds) / speed;
    double sin = motion.velocityY(seconds) / speed;
    int x = (int) Math.floor(motion.x(seconds) + ahead * cos - across * sin + 0.5);
    int y = (int) Math.floor(motion.y(seconds) + ahead * sin + across * cos + 0.5);
    if (geometry.contains(x, y)) {
      merger.add(nextUs, EventAddress.pack(x, y, on));
    }
  }
}
