package haltere.testing.objects;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.testing.EventList;
import haltere.testing.MemoryRecording;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;

/**
 * Simulated scenes of two to eight objects of one look, which move along lines and ellipses, cross,
 * overtake each other side by side with a gap of half a width, and stop for two seconds. All else
 * is drawn from wide ranges: sensor, sizes, speeds, contrast, losses, noise and hot pixels. Noise
 * is at most a share of the event density of the faintest object, so that a person sees all of
 * them.
 *
 * <p>{@link SimulatedTruth} tells which objects count. The same seed makes the same scene.
 */
final class Looks {
  /** Appearance of the objects, or clutter in the picture. */
  enum Look {
    /** Ellipses and rectangles of one brightness. */
    FILLED,
    /** Ellipses and rectangles of which only the outline is seen. */
    OUTLINE,
    /** A leading and a trailing edge. */
    EDGES,
    /** Ellipses and rectangles with a random texture. */
    TEXTURED,
    /** A pixel of an edge fires once in two passings: one event or none, at random. */
    SPARSE,
    /** Persons who walk, with limbs that swing. */
    WALKER,
    /** Objects that pass behind bars. */
    HIDDEN,
    /** Objects with a shadow beside them. */
    SHADOW,
    /** A flickering lamp in the picture. */
    LAMP,
    /** Leaves that move in a part of the picture, behind the objects. */
    LEAVES
  }

  private static final double DURATION_S = 10;
  private static final long STEP_US = SimulatedTruth.STEP_US;
  private static final int[][] SENSORS = {
    {128, 128}, {240, 180}, {346, 260}, {640, 480}, {1280, 720}
  };
  private static final int MAX_OBJECTS = 8;

  /** Limits of the covered area, as a share of the picture and in pixels: they bound the time. */
  private static final double MAX_COVERED = 0.12;

  private static final double MAX_COVERED_PX = 16_000;
  private static final double MAX_COVERED_BY_WALKERS_PX = 8_000;
  private static final int MAX_LEAVES = 200;
  private static final double MIN_SEEN_S = 4;
  private static final double MIN_PASSING_S = 5;

  /** Fewer events of an object are not seen by a person. */
  private static final double MIN_EVENTS_PER_S = 300;

  private static final double MAX_NOISE_SHARE = 0.3;
  private static final double MAX_NOISE_EVENTS_PER_S = 3e5;

  /** Of the four events of a passing, at least one is left in half of the passings: 1 - 0.84⁴. */
  private static final double LOST_OF_SPARSE = 0.84;

  private final Look look;
  private final SplittableRandom random;
  private final SensorGeometry geometry;
  private final double side;
  private final BrightnessSensor sensor;
  private final List<Sprite> objects = new ArrayList<>();

  private Looks(Look look, long seed, int sensors) {
    this.look = look;
    random = new SplittableRandom(seed * 31 + look.ordinal());
    int[] size = SENSORS[random.nextInt(sensors)];
    geometry = new SensorGeometry(size[0], size[1]);
    side = Math.min(size[0], size[1]);
    sensor = new BrightnessSensor(geometry, random.split());
    if (look == Look.SPARSE) {
      sensor.lose(LOST_OF_SPARSE);
    }
    int wanted = random.nextInt(2, MAX_OBJECTS + 1);
    // A first object may leave no room for a second one; another draw has.
    for (int tries = 0;
        tries < 100 && objects.size() < wanted || tries < 1000 && objects.size() < 2;
        tries++) {
      addObjects(wanted);
    }
  }

  /** Makes a scene. */
  static ObjectScene scene(Look look, long seed) {
    return scene(look, seed, SENSORS.length);
  }

  /** Makes a scene on one of the smaller sensors. */
  static ObjectScene scene(Look look, long seed, int sensors) {
    String name = look.name().toLowerCase(Locale.ROOT);
    for (long i = 0; ; i++) {
      Looks drawn = new Looks(look, seed * 1000 + i, sensors);
      ObjectScene scene = drawn.objects.size() < 2 ? null : drawn.scene(name, seed);
      if (scene != null) {
        return scene;
      }
    }
  }

  private double between(double min, double max) {
    return min * Math.pow(max / min, random.nextDouble());
  }

  private void addObjects(int wanted) {
    double x = geometry.width() * random.nextDouble(0.25, 0.75);
    double y = geometry.height() * random.nextDouble(0.25, 0.75);
    double angle = random.nextDouble(2 * Math.PI);
    double meetingS = DURATION_S * random.nextDouble(0.25, 0.75);
    double maxRadius = Math.sqrt(maxCoveredPx() / wanted) / 2;
    double radius = Math.max(4, Math.min(maxRadius, side * between(0.03, 0.1)));
    double speed = Math.max(12, 2 * radius * between(0.7, 5));
    double maxLineSpeed = Math.hypot(geometry.width(), geometry.height()) / MIN_PASSING_S;
    boolean pair = objects.size() + 1 < wanted && random.nextBoolean();
    if (pair) {
      speed = Math.min(speed, maxLineSpeed / 1.5);
      Motion line = Motion.line(random, x, y, angle, speed, meetingS);
      Sprite first = sprite(line, radius);
      boolean overtakes = random.nextBoolean();
      Sprite second;
      if (overtakes) {
        second = sprite(line, radius * between(0.7, 1.4));
        second = overtaking(first, second, angle);
      } else {
        double other = angle + (random.nextBoolean() ? 1 : -1) * random.nextDouble(0.5, Math.PI);
        double otherSpeed = Math.min(maxLineSpeed, speed * between(0.5, 2));
        double when = meetingS + random.nextDouble(-0.05, 0.05);
        second =
            sprite(Motion.line(random, x, y, other, otherSpeed, when), radius * between(0.7, 1.4));
      }
      if (isAccepted(first, objects)
          && isAccepted(second, objects)
          && isAccepted(second, List.of(first))) {
        objects.add(first);
        objects.add(second);
      }
    } else {
      boolean line = speed < maxLineSpeed && random.nextInt(3) > 0;
      double halfWidth = random.nextDouble(0.15, 0.4) * geometry.width();
      double halfHeight = random.nextDouble(0.15, 0.4) * geometry.height();
      Motion motion =
          line
              ? Motion.line(random, x, y, angle, speed, meetingS)
              : Motion.orbit(random, x, y, halfWidth, halfHeight, speed);
      if (random.nextInt(3) == 0) {
        motion = motion.stopping(random.nextDouble(1.5, DURATION_S - 4));
      }
      Sprite alone = sprite(motion, radius);
      if (isAccepted(alone, objects)) {
        objects.add(alone);
      }
    }
  }

  /** The second object beside the path of the first, faster, with a gap of half a width. */
  private Sprite overtaking(Sprite first, Sprite second, double angle) {
    double one = across(first, angle);
    double other = across(second, angle);
    double aside = (one + other + Math.min(one, other)) * (random.nextBoolean() ? 1 : -1);
    Motion motion =
        first
            .motion()
            .beside(-aside * Math.sin(angle), aside * Math.cos(angle), random.nextDouble(1.3, 2));
    return second.on(motion);
  }

  /** Half of the extent across a direction. */
  private static double across(Sprite sprite, double angle) {
    Box box = sprite.box(0);
    return (box.width() * Math.abs(Math.sin(angle)) + box.height() * Math.abs(Math.cos(angle))) / 2;
  }

  private Sprite sprite(Motion motion, double radius) {
    boolean plain = random.nextBoolean();
    double stroke = random.nextDouble(1.5, 3);
    double aspect = Math.sqrt(between(0.6, 1.7));
    double a = radius * aspect;
    double b = radius / aspect;
    Shape shape =
        switch (look) {
          case FILLED, TEXTURED -> filled(plain, a, b);
          case OUTLINE -> outline(plain, a, b, stroke);
          case EDGES -> new Shape(Shape.ShapeKind.EDGES, 1.3 * a, 0.7 * b, stroke);
          case WALKER ->
              new Shape(
                  Shape.ShapeKind.WALKER,
                  1.3 * radius / Shape.WALKER_ASPECT,
                  1.3 * radius,
                  Math.max(1.5, 0.16 * radius));
          default ->
              switch (random.nextInt(3)) {
                case 0 -> outline(plain, a, b, stroke);
                case 1 -> new Shape(Shape.ShapeKind.EDGES, 1.3 * a, 0.7 * b, stroke);
                default -> filled(plain, a, b);
              };
        };
    double contrast =
        look == Look.SPARSE
            ? BrightnessSensor.THRESHOLD * random.nextDouble(4, 4.4)
            : random.nextDouble(0.35, 1.5);
    boolean edges = shape.kind() == Shape.ShapeKind.EDGES;
    boolean walker = look == Look.WALKER;
    Sprite sprite =
        new Sprite(
            motion,
            shape,
            edges || !walker && random.nextBoolean(),
            walker ? 0 : random.nextDouble(Math.PI),
            random.nextBoolean() ? contrast : -contrast);
    if (look == Look.TEXTURED) {
      sprite.addTexture(random, random.nextDouble(0.4, 1), random.nextDouble(2, 2 + radius / 2));
    }
    return sprite;
  }

  private static Shape filled(boolean ellipse, double a, double b) {
    return new Shape(ellipse ? Shape.ShapeKind.ELLIPSE : Shape.ShapeKind.RECTANGLE, a, b, 0);
  }

  private static Shape outline(boolean ellipse, double a, double b, double stroke) {
    return new Shape(ellipse ? Shape.ShapeKind.RING : Shape.ShapeKind.FRAME, a, b, stroke);
  }

  /**
   * Whether it is in the picture for long, begins apart from others, and overlaps one at a time and
   * not for long.
   */
  private boolean isAccepted(Sprite sprite, List<Sprite> others) {
    double covered = area(sprite);
    for (Sprite other : objects) {
      covered += area(other);
    }
    if (covered > maxCoveredPx()) {
      return false;
    }
    double seenS = 0;
    double[] onS = new double[others.size()];
    for (double s = 0; s < DURATION_S; s += 0.05) {
      Box box = sprite.box(s);
      if (!geometry.contains((int) Math.round(box.centreX()), (int) Math.round(box.centreY()))) {
        continue;
      }
      int overlaps = 0;
      for (int k = 0; k < onS.length; k++) {
        if (box.gapTo(others.get(k).box(s)) < 0) {
          onS[k] += 0.05;
          overlaps++;
          if (seenS < 0.5 || onS[k] > 0.25 * DURATION_S || overlaps > 1) {
            return false;
          }
        }
      }
      seenS += sprite.motion().pace(s) > 0 ? 0.05 : 0;
    }
    return seenS > MIN_SEEN_S;
  }

  private double maxCoveredPx() {
    return Math.min(
        MAX_COVERED * geometry.pixels(),
        look == Look.WALKER ? MAX_COVERED_BY_WALKERS_PX : MAX_COVERED_PX);
  }

  private static double area(Sprite sprite) {
    Box box = sprite.box(0);
    return box.width() * box.height();
  }

  /** Null if an object is too faint. */
  private ObjectScene scene(String name, long seed) {
    EventList events = new EventList();
    List<Sprite> sprites = new ArrayList<>();
    double radius = Math.sqrt(area(objects.get(0))) / 2;
    switch (look) {
      case HIDDEN -> hide(radius);
      case LEAVES -> addLeaves(sprites);
      case SHADOW -> {
        double dx = random.nextDouble(-0.9, 0.9);
        double dy = random.nextDouble(-0.9, -0.3);
        double dark = random.nextDouble(0.15, 0.4);
        objects.forEach(
            one -> sprites.add(one.shadow(dark, dx * one.shape().a(), dy * one.shape().b())));
      }
      default -> {
        // nothing but objects
      }
    }
    sprites.addAll(objects);
    sensor.show(sprites, DURATION_S, events);
    List<TruthMoment> truth = truth();
    double faintest = faintest(events.sorted(0, Long.MAX_VALUE), truth);
    if (faintest == 0) {
      return null;
    }
    if (look == Look.LAMP) {
      Box lamp =
          Box.around(
              geometry.width() * random.nextDouble(0.1, 0.9),
              geometry.height() * random.nextDouble(0.1, 0.9),
              random.nextDouble(3, 10),
              1);
      double reach = lamp.width() / 2;
      sensor.flicker(
          Box.around(lamp.centreX(), lamp.centreY(), reach, reach),
          random.nextBoolean() ? 100 : 120,
          random.nextInt(1, 3),
          DURATION_S,
          events);
    }
    double noiseHz =
        Math.min(
            between(0.05, 5),
            Math.min(MAX_NOISE_SHARE * faintest, MAX_NOISE_EVENTS_PER_S / geometry.pixels()));
    sensor.noise(noiseHz, random.nextInt(6), random.nextDouble(10, 100), DURATION_S, events);
    EventPacket packet = events.sorted(0, (long) (DURATION_S * 1e6));
    return new ObjectScene(
        "look-" + name + "-" + seed,
        "look " + name,
        () -> new MemoryRecording(geometry, packet),
        truth,
        Matching.CENTRE);
  }

  private void hide(double radius) {
    int bars = random.nextInt(1, 4);
    boolean upright = random.nextBoolean();
    for (int i = 0; i < bars; i++) {
      double half = radius * random.nextDouble(0.5, 1.5);
      double position = random.nextDouble(0.2, 0.8);
      double w = geometry.width();
      double h = geometry.height();
      sensor.hide(
          upright
              ? new Box(position * w - half, 0, position * w + half, h)
              : new Box(0, position * h - half, w, position * h + half));
    }
  }

  private void addLeaves(List<Sprite> sprites) {
    double share = random.nextDouble(0.25, 0.4);
    boolean upright = random.nextBoolean();
    double w = geometry.width() * (upright ? share : 1);
    double h = geometry.height() * (upright ? 1 : share);
    double reach = Math.sqrt(side / 128);
    int leaves = (int) Math.min(MAX_LEAVES, w * h / (reach * reach * between(30, 120)));
    for (int i = 0; i < leaves; i++) {
      double amplitude = random.nextDouble(0.5, 1.5) * reach;
      Motion sway =
          Motion.orbit(
              random,
              random.nextDouble(w),
              geometry.height() - random.nextDouble(h),
              amplitude,
              amplitude * random.nextDouble(0.2, 1),
              amplitude * random.nextDouble(2, 12));
      Shape leaf =
          new Shape(Shape.ShapeKind.ELLIPSE, reach * between(1, 2), reach * between(1, 2), 0);
      double level = random.nextDouble(0.3, 0.8) * (random.nextBoolean() ? 1 : -1);
      sprites.add(new Sprite(sway, leaf, false, random.nextDouble(Math.PI), level));
    }
  }

  private List<TruthMoment> truth() {
    SimulatedTruth truth = new SimulatedTruth(geometry);
    for (long timeUs = STEP_US; timeUs < DURATION_S * 1e6; timeUs += STEP_US) {
      double s = timeUs * 1e-6;
      objects.forEach(object -> object.moveTo(s));
      for (int k = 0; k < objects.size(); k++) {
        Box box = objects.get(k).box(s);
        Motion motion = objects.get(k).motion();
        TrueObject object = new TrueObject(k, box, motion.vx(s), motion.vy(s));
        truth.add(object, visible(box, k), motion, s);
      }
      truth.end(timeUs);
    }
    return truth.moments();
  }

  /** Share of an object's box that is in the picture and neither hidden nor behind another one. */
  private double visible(Box box, int k) {
    int seen = 0;
    int steps = 8;
    for (int i = 0; i < steps * steps; i++) {
      double x = box.x0() + (i % steps + 0.5) / steps * box.width();
      double y = box.y0() + (i / steps + 0.5) / steps * box.height();
      int column = (int) Math.round(x);
      int row = (int) Math.round(y);
      boolean visible = geometry.contains(column, row) && !sensor.isHidden(column, row);
      for (int front = k + 1; front < objects.size() && visible; front++) {
        visible = objects.get(front).coverage(x, y) < 0.5;
      }
      seen += visible ? 1 : 0;
    }
    return (double) seen / (steps * steps);
  }

  /** Events for each pixel and second in the box of the faintest object; 0 if it makes too few. */
  private double faintest(EventPacket events, List<TruthMoment> truth) {
    double[] counts = new double[objects.size()];
    double[] areas = new double[objects.size()];
    double[] seconds = new double[objects.size()];
    for (TruthMoment moment : truth) {
      for (TrueObject object : moment.objects()) {
        areas[object.id()] += object.box().width() * object.box().height() * STEP_US * 1e-6;
        seconds[object.id()] += STEP_US * 1e-6;
      }
      for (int i = events.indexAtOrAfter(moment.timeUs() - STEP_US / 2);
          i < events.size() && events.timeUs(i) < moment.timeUs() + STEP_US / 2;
          i++) {
        for (TrueObject object : moment.objects()) {
          counts[object.id()] += object.box().contains(events.x(i), events.y(i), 0) ? 1 : 0;
        }
      }
    }
    double faintest = Double.POSITIVE_INFINITY;
    for (int k = 0; k < counts.length; k++) {
      boolean seen = seconds[k] > 0 && counts[k] / seconds[k] >= MIN_EVENTS_PER_S;
      faintest = Math.min(faintest, seen ? counts[k] / areas[k] : 0);
    }
    return faintest;
  }
}
