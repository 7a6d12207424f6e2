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
 * Simulated roads seen from above, by rules of their own: a car is a leading and a trailing edge,
 * each of which makes a stated mean number of events at each pixel that it passes. Cars have a size
 * and a speed in pixels; there is no perspective. {@link SimulatedTruth} tells which cars count.
 * The same seed makes the same scene.
 */
final class Roads {
  /** Kinds of traffic. */
  enum Traffic {
    /** One after the other, each lane at its own speeds. */
    FREE,
    /** A car overtakes another with a gap of 7 to 8 pixels between their sides. */
    OVERTAKING,
    /** Cars close up, stand for two seconds and go on. */
    QUEUE
  }

  /** Number of events of an edge at a pixel. */
  enum EdgeEvents {
    /** One in two passings. */
    HALF(0.5),
    /** About two. */
    TWO(2),
    /** About five. */
    FIVE(5);

    private final double mean;

    EdgeEvents(double mean) {
      this.mean = mean;
    }
  }

  private static final double DURATION_S = 10;
  private static final int[][] SENSORS = {{128, 128}, {240, 180}, {346, 260}};

  private static final int MAX_LANES = 4;

  /** The longest cars, in widths. */
  private static final double LONGEST = 2.5;

  private record Car(Motion motion, double length, double width, boolean bright) {
    /** Along the road first. */
    Box box(double s) {
      return Box.around(motion.x(s), motion.y(s), length / 2, width / 2);
    }

    /**
     * When a point at an offset from the centre passes a column; bisection, for it never returns.
     */
    double passingS(double offset, double column) {
      double from = 0;
      double to = DURATION_S;
      double sign = Math.signum(motion.ax());
      if (sign * (motion.x(to) + offset - column) < 0
          || sign * (motion.x(from) + offset - column) > 0) {
        return Double.NaN;
      }
      for (int i = 0; i < 40; i++) {
        double middle = (from + to) / 2;
        if (sign * (motion.x(middle) + offset - column) < 0) {
          from = middle;
        } else {
          to = middle;
        }
      }
      return from;
    }
  }

  private final SplittableRandom random;
  private final SensorGeometry geometry;
  private final boolean upright;
  private final double along;
  private final double across;
  private final List<Car> cars = new ArrayList<>();

  private Roads(Traffic traffic, EdgeEvents events, long seed) {
    random = new SplittableRandom((seed * 3 + traffic.ordinal()) * 3 + events.ordinal());
    int[] size = SENSORS[random.nextInt(SENSORS.length)];
    geometry = new SensorGeometry(size[0], size[1]);
    upright = random.nextBoolean();
    along = upright ? size[1] : size[0];
    across = upright ? size[0] : size[1];
    double y = 10 + random.nextDouble(10);
    for (int lane = 0; lane < MAX_LANES && y < across - 10; lane++) {
      double width = random.nextDouble(6, 12);
      double direction = random.nextBoolean() ? 1 : -1;
      // From one side to the other in 2 to 6 s.
      double speed = direction * along / random.nextDouble(2, 6);
      double gap = random.nextDouble(7, 8);
      switch (traffic) {
        case FREE -> addLane(y, width, speed);
        case QUEUE -> addQueue(y, width, speed);
        case OVERTAKING -> {
          double other = random.nextDouble(6, 12);
          double beside = y + (width + other) / 2 + gap;
          addPair(y, width, beside, other, speed / random.nextDouble(1, 2));
          y = beside;
          width = other;
        }
      }
      y += width + random.nextDouble(12, across / 3);
    }
  }

  private void addCar(double y, double width, double x, double speed, double atS, double stopS) {
    Motion motion = new Motion(false, x, y, speed, 0, 0, 0, 0, 0, atS, stopS);
    cars.add(new Car(motion, width * random.nextDouble(1.2, LONGEST), width, random.nextBoolean()));
  }

  private void addLane(double y, double width, double speed) {
    double start = speed > 0 ? 0 : along;
    for (double s = -2 + random.nextDouble(2); s < DURATION_S - 2; ) {
      addCar(y, width, start, speed, s, Double.NaN);
      double headway = (LONGEST * width + random.nextDouble(30, 150)) / Math.abs(speed);
      s += headway;
    }
  }

  private void addQueue(double y, double width, double speed) {
    double start = speed > 0 ? 0 : along;
    double stopS = random.nextDouble(2.5, 3.5);
    double firstS = stopS - random.nextDouble(0.6, 0.9) * along / Math.abs(speed);
    int n = random.nextInt(2, 5);
    for (int k = 0; k < n; k++) {
      // Each starts farther behind than it stands: the later it brakes, the closer it comes.
      double closing = random.nextDouble(0.1, 0.3);
      double headway = (LONGEST * width + random.nextDouble(6, 15)) / Math.abs(speed) + closing;
      addCar(y, width, start, speed, firstS + k * headway, stopS + k * closing);
    }
  }

  private void addPair(double y, double width, double beside, double other, double speed) {
    for (double s = random.nextDouble(1, 2.5); s < DURATION_S - 1; s += random.nextDouble(4, 6)) {
      double x = along * random.nextDouble(0.35, 0.65);
      addCar(y, width, x, speed, s, Double.NaN);
      addCar(beside, other, x, speed * random.nextDouble(1.25, 1.8), s, Double.NaN);
    }
  }

  /** Makes a scene. */
  static ObjectScene scene(Traffic traffic, EdgeEvents edges, long seed) {
    Roads road = new Roads(traffic, edges, seed);
    EventList events = new EventList();
    for (Car car : road.cars) {
      road.addEdge(car, car.length / 2, edges.mean, car.bright, events);
      road.addEdge(car, -car.length / 2, edges.mean, !car.bright, events);
    }
    BrightnessSensor noise = new BrightnessSensor(road.geometry, road.random.split());
    double noiseHz = 0.05 * Math.pow(10, road.random.nextDouble());
    noise.noise(noiseHz, road.random.nextInt(4), 30, DURATION_S, events);
    EventPacket packet = events.sorted(0, (long) (DURATION_S * 1e6));
    String kind = (traffic.name() + " " + edges.name()).toLowerCase(Locale.ROOT);
    return new ObjectScene(
        "road-" + kind.replace(' ', '-') + "-" + seed,
        "road " + kind,
        () -> new MemoryRecording(road.geometry, packet),
        road.truth(),
        Matching.GATE);
  }

  private void addEdge(Car car, double offset, double mean, boolean on, EventList events) {
    int y0 = (int) Math.ceil(car.motion.y() - car.width / 2);
    int y1 = (int) Math.floor(car.motion.y() + car.width / 2);
    double sign = Math.signum(car.motion.ax());
    for (int column = 0; column < along; column++) {
      double passingS = car.passingS(sign * offset, column);
      for (int row = y0; row <= y1 && !Double.isNaN(passingS); row++) {
        double us = passingS * 1e6;
        for (int n = poisson(mean); n > 0; n--) {
          us += random.nextDouble(200, 2500);
          int x = upright ? row : column;
          int y = upright ? column : row;
          if (geometry.contains(x, y)) {
            events.add((long) us, x, y, on);
          }
        }
      }
    }
  }

  /** Knuth (1969), for small means. */
  private int poisson(double mean) {
    double limit = Math.exp(-mean);
    int n = 0;
    for (double product = random.nextDouble(); product > limit; n++) {
      product *= random.nextDouble();
    }
    return n;
  }

  private List<TruthMoment> truth() {
    SimulatedTruth truth = new SimulatedTruth(geometry);
    for (long timeUs = SimulatedTruth.STEP_US;
        timeUs < DURATION_S * 1e6;
        timeUs += SimulatedTruth.STEP_US) {
      double s = timeUs * 1e-6;
      for (int k = 0; k < cars.size(); k++) {
        Motion motion = cars.get(k).motion;
        Box box = cars.get(k).box(s);
        TrueObject car =
            upright
                ? new TrueObject(
                    k, new Box(box.y0(), box.x0(), box.y1(), box.x1()), 0, motion.vx(s))
                : new TrueObject(k, box, motion.vx(s), 0);
        truth.add(car, 1, motion, s);
      }
      truth.end(timeUs);
    }
    return truth.moments();
  }
}
