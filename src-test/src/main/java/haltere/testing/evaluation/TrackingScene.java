package haltere.testing.evaluation;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;

/**
 * A seeded scene for trackers: two to eight discs that enter and leave, straight or swinging, half
 * of them made to meet another one in the picture, at another angle or overtaking it on its own
 * way; in the noise of a camera. Sensor, sizes, speeds and rates are drawn anew for each seed.
 *
 * <p>The edge in front of a disc makes OFF events, the edge behind ON events, at random times and
 * places along it, as many as pixels are swept times a factor.
 *
 * @param geometry of the sensor
 * @param events all of them; whoever filters in place takes a copy
 * @param timesUs when the truth is told, each 10 ms, while events come
 * @param truth where the centres of the discs on the sensor are at these times
 * @param halfSeen where the centres of discs are that are off the sensor while a part is on it: a
 *     track there is neither right nor wrong
 * @param encounters of two discs
 */
public record TrackingScene(
    SensorGeometry geometry,
    EventPacket events,
    long[] timesUs,
    List<ObjectPoint> truth,
    List<ObjectPoint> halfSeen,
    List<Encounter> encounters) {
  private static final double DURATION_S = 3;
  private static final int TICK_US = 10_000;
  private static final double MIN_VISIBLE_S = 0.5;
  private static final int[][] SENSORS = {{128, 128}, {240, 180}, {346, 260}};

  /**
   * Two discs that touch or cover each other for a while, and were apart before and after.
   *
   * @param first identity of a disc
   * @param second identity of the other
   * @param fromUs when they begin to touch
   * @param toUs when they are apart again
   * @param relativeSpeed difference of their velocities in the middle, pixels a second
   */
  public record Encounter(int first, int second, long fromUs, long toUs, double relativeSpeed) {}

  /**
   * Makes a scene.
   *
   * @param seed always makes the same one
   * @return the scene
   */
  public static TrackingScene of(long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    int[] size = SENSORS[random.nextInt(SENSORS.length)];
    SensorGeometry geometry = new SensorGeometry(size[0], size[1]);
    int objects = random.nextInt(2, 9);
    List<DiscPath> paths = new ArrayList<>();
    while (paths.size() < objects) {
      addPaths(random, geometry, paths, objects);
    }
    List<ObjectPoint> truth = new ArrayList<>();
    List<ObjectPoint> halfSeen = new ArrayList<>();
    // not at the end of the events: the state of a time is reported after a later event
    int ticks = (int) (DURATION_S * 1e6 / TICK_US) - 1;
    long[] timesUs = IntStream.rangeClosed(1, ticks).mapToLong(i -> (long) i * TICK_US).toArray();
    for (long timeUs : timesUs) {
      for (int id = 0; id < paths.size(); id++) {
        DiscPath path = paths.get(id);
        double s = timeUs * 1e-6;
        ObjectPoint point =
            new ObjectPoint(timeUs, id, path.x(s), path.y(s), path.velocityX(s), path.velocityY(s));
        if (isOn(geometry, path, s, 0)) {
          truth.add(point);
        } else if (isOn(geometry, path, s, path.radius() + 1)) {
          halfSeen.add(point);
        }
      }
    }
    return new TrackingScene(
        geometry,
        events(random, geometry, paths),
        timesUs,
        List.copyOf(truth),
        List.copyOf(halfSeen),
        encounters(geometry, paths, timesUs));
  }

  private static void addPaths(
      SplittableRandom random, SensorGeometry geometry, List<DiscPath> paths, int objects) {
    double x = geometry.width() * random.nextDouble(0.25, 0.75);
    double y = geometry.height() * random.nextDouble(0.25, 0.75);
    double whenS = DURATION_S * random.nextDouble(0.25, 0.75);
    double angle = random.nextDouble(2 * Math.PI);
    double speed = 40 * Math.pow(7.5, random.nextDouble());
    addIfLong(paths, geometry, DiscPath.through(random, whenS, x, y, angle, speed));
    if (paths.size() < objects && random.nextBoolean()) {
      boolean overtakes = random.nextInt(3) == 0;
      double otherAngle = overtakes ? angle : angle + random.nextDouble(0.4, 2 * Math.PI - 0.4);
      double otherSpeed =
          overtakes ? speed * random.nextDouble(1.4, 2.5) : 40 * Math.pow(7.5, random.nextDouble());
      double aside = overtakes ? random.nextDouble(-6, 6) : 0;
      addIfLong(
          paths,
          geometry,
          DiscPath.through(
              random,
              whenS + random.nextDouble(-0.02, 0.02),
              x - aside * Math.sin(angle),
              y + aside * Math.cos(angle),
              otherAngle,
              otherSpeed));
    }
  }

  private static void addIfLong(List<DiscPath> paths, SensorGeometry geometry, DiscPath path) {
    int visible = 0;
    for (double s = 0; s < DURATION_S; s += 0.01) {
      visible += isOn(geometry, path, s, 0) ? 1 : 0;
    }
    if (visible * 0.01 >= MIN_VISIBLE_S) {
      paths.add(path);
    }
  }

  private static boolean isOn(
      SensorGeometry geometry, DiscPath path, double seconds, double margin) {
    double x = path.x(seconds) + margin;
    double y = path.y(seconds) + margin;
    double more = 2 * margin - 1;
    return x >= 0 && y >= 0 && x <= geometry.width() + more && y <= geometry.height() + more;
  }

  private static EventPacket events(
      SplittableRandom random, SensorGeometry geometry, List<DiscPath> paths) {
    List<long[]> events = new ArrayList<>();
    double perPixel = random.nextDouble(1, 3);
    for (DiscPath path : paths) {
      double maxSpeed =
          Math.hypot(path.vx(), path.vy()) + 2 * Math.PI * path.swing() * path.swingHz();
      double maxHz = 4 * path.radius() * maxSpeed * perPixel;
      for (double s = pause(random, maxHz); s < DURATION_S; s += pause(random, maxHz)) {
        if (random.nextDouble() * maxSpeed < path.speed(s)) {
          addEvent(random, geometry, path, s, events);
        }
      }
    }
    double noiseHz = random.nextDouble(0.1, 1) * geometry.pixels();
    for (double s = pause(random, noiseHz); s < DURATION_S; s += pause(random, noiseHz)) {
      int x = random.nextInt(geometry.width());
      int y = random.nextInt(geometry.height());
      events.add(new long[] {(long) (s * 1e6), EventAddress.pack(x, y, random.nextBoolean())});
    }
    events.sort((a, b) -> Long.compare(a[0], b[0]));
    EventPacket packet = new EventPacket(events.size());
    events.forEach(event -> packet.append(event[0], (int) event[1]));
    return packet;
  }

  private static double pause(SplittableRandom random, double rateHz) {
    return -Math.log(1 - random.nextDouble()) / rateHz;
  }

  private static void addEvent(
      SplittableRandom random,
      SensorGeometry geometry,
      DiscPath path,
      double seconds,
      List<long[]> events) {
    double across = random.nextDouble(-path.radius(), path.radius());
    double ahead = Math.sqrt(path.radius() * path.radius() - across * across);
    boolean on = random.nextBoolean();
    double along = on ? -ahead : ahead;
    double cos = path.velocityX(seconds) / path.speed(seconds);
    double sin = path.velocityY(seconds) / path.speed(seconds);
    int x = (int) Math.floor(path.x(seconds) + along * cos - across * sin + 0.5);
    int y = (int) Math.floor(path.y(seconds) + along * sin + across * cos + 0.5);
    if (geometry.contains(x, y)) {
      events.add(new long[] {(long) (seconds * 1e6), EventAddress.pack(x, y, on)});
    }
  }

  private static List<Encounter> encounters(
      SensorGeometry geometry, List<DiscPath> paths, long[] timesUs) {
    List<Encounter> encounters = new ArrayList<>();
    for (int i = 0; i < paths.size(); i++) {
      for (int j = i + 1; j < paths.size(); j++) {
        addEncounters(geometry, paths, i, j, timesUs, encounters);
      }
    }
    return List.copyOf(encounters);
  }

  private static void addEncounters(
      SensorGeometry geometry,
      List<DiscPath> paths,
      int i,
      int j,
      long[] timesUs,
      List<Encounter> encounters) {
    DiscPath first = paths.get(i);
    DiscPath second = paths.get(j);
    long fromUs = -1;
    for (long timeUs : timesUs) {
      double s = timeUs * 1e-6;
      if (!isOn(geometry, first, s, 0) || !isOn(geometry, second, s, 0)) {
        fromUs = -1;
        continue;
      }
      double distance = Math.hypot(first.x(s) - second.x(s), first.y(s) - second.y(s));
      boolean touching = distance < first.radius() + second.radius();
      if (touching && fromUs < 0) {
        fromUs = timeUs;
      } else if (!touching && fromUs >= 0) {
        double middleS = (fromUs + timeUs) * 0.5e-6;
        encounters.add(
            new Encounter(
                i,
                j,
                fromUs,
                timeUs,
                Math.hypot(
                    first.velocityX(middleS) - second.velocityX(middleS),
                    first.velocityY(middleS) - second.velocityY(middleS))));
        fromUs = -1;
      }
    }
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof TrackingScene scene
        && events.equals(scene.events)
        && Arrays.equals(timesUs, scene.timesUs)
        && truth.equals(scene.truth);
  }

  @Override
  public int hashCode() {
    return truth.hashCode();
  }
}
