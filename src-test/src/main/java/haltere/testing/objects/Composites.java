package haltere.testing.objects;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.testing.EventList;
import haltere.testing.MemoryRecording;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;

/**
 * Real recordings with one object each, laid into one larger picture: mirrored, scaled, and slid
 * across it, so that their boxes are known. Objects are transparent: where they overlap, the events
 * of both are there. The same seed makes the same composite.
 */
final class Composites {
  /** Arrangement of the objects of a composite. */
  enum Arrangement {
    /** Never close to each other. */
    APART,
    /** Two of them slide across one another about the middle of the scene. */
    CROSSING,
    /** Two of them stay beside each other, close by. */
    BESIDE
  }

  private static final int OBJECTS = 3;
  private static final int TRIES = 4000;
  private static final double MIN_APART_GAP_PX = 10;
  private static final double MAX_BESIDE_GAP_PX = 10;
  private static final double MIN_BESIDE_GAP_PX = 2;

  /** Copies of an event in a scaled-up picture come within this time, microseconds. */
  private static final int COPIES_WITHIN_US = 500;

  private static final double MIN_VISIBLE = 0.5;

  /** Margin around the last known box of an object whose box is unknown, pixels. */
  private static final double UNKNOWN_PX = 12;

  private final Arrangement kind;
  private final SplittableRandom random;
  private final int factor;
  private final SensorGeometry geometry;
  private final List<CompositeSource> sources = new ArrayList<>();

  private Composites(Arrangement kind, long seed) throws IOException {
    this.kind = kind;
    random = new SplittableRandom(seed * 3 + kind.ordinal());
    factor = random.nextInt(4) == 0 ? 2 : 1;
    geometry = factor == 2 ? new SensorGeometry(640, 480) : new SensorGeometry(346, 260);
    List<Integer> left = new ArrayList<>();
    for (int i = 0; i < CompositeSource.choices(); i++) {
      left.add(i);
    }
    while (sources.size() < OBJECTS) {
      int choice = left.remove(random.nextInt(left.size()));
      sources.add(CompositeSource.of(choice, random));
    }
  }

  /** Makes a composite. */
  static ObjectScene scene(Arrangement kind, long seed) throws IOException {
    for (long i = 0; ; i++) {
      // Some recordings do not fit together; others are drawn then.
      Composites composite = new Composites(kind, seed * 1000 + i);
      List<Slide> slides = composite.slides();
      if (slides != null) {
        return composite.scene(slides, kind.name().toLowerCase(Locale.ROOT), seed);
      }
    }
  }

  /**
   * How a source is laid into the picture: scale, negative where mirrored, position and velocity.
   */
  private record Slide(
      CompositeSource source, double sx, double sy, double x, double y, double vx, double vy) {
    double x(double movingS) {
      return x + vx * movingS;
    }

    double y(double movingS) {
      return y + vy * movingS;
    }

    /** The box at a step, or the nearest known one. */
    Box box(int step) {
      double movingS = source.movingS(step * CompositeSource.STEP_US);
      return source.filled()[step].mapped(sx, sy, x(movingS), y(movingS));
    }
  }

  /** Draws until all is as the kind wants it; null if it never is. */
  private List<Slide> slides() {
    for (int i = 0; i < TRIES; i++) {
      List<Slide> slides = new ArrayList<>();
      double angle = random.nextDouble(2 * Math.PI);
      double speed =
          switch (kind) {
            case APART -> random.nextDouble(0, 15);
            case CROSSING -> random.nextDouble(20, 60);
            case BESIDE -> random.nextDouble(0, 30);
          };
      int meeting = random.nextInt(CompositeSource.STEPS * 2 / 5, CompositeSource.STEPS * 3 / 5);
      double x = geometry.width() * random.nextDouble(0.25, 0.75);
      double y = geometry.height() * random.nextDouble(0.25, 0.75);
      for (int k = 0; k < OBJECTS; k++) {
        boolean pair = k < 2 && kind != Arrangement.APART;
        double sign = kind == Arrangement.CROSSING && k == 1 ? -1 : 1;
        double own = pair ? speed : random.nextDouble(0, 15);
        double way = pair ? angle : random.nextDouble(2 * Math.PI);
        slides.add(
            slide(
                sources.get(k),
                meeting,
                pair ? x : geometry.width() * random.nextDouble(),
                pair ? y : geometry.height() * random.nextDouble(),
                sign * own * factor * Math.cos(way),
                sign * own * factor * Math.sin(way)));
      }
      if (kind == Arrangement.BESIDE) {
        slides.set(1, beside(slides.get(0), slides.get(1)));
      }
      if (isAccepted(slides)) {
        return slides;
      }
    }
    return null;
  }

  /** A slide that has the object's centre at a point at a step. */
  private Slide slide(CompositeSource source, int step, double x, double y, double vx, double vy) {
    double sx = source.scale() * factor * (random.nextBoolean() ? 1 : -1);
    double sy = source.scale() * factor * (random.nextInt(4) > 0 ? 1 : -1);
    double movingS = source.movingS(step * CompositeSource.STEP_US);
    Box box = source.filled()[step];
    return new Slide(
        source,
        sx,
        sy,
        x - sx * box.centreX() - vx * movingS,
        y - sy * box.centreY() - vy * movingS,
        vx,
        vy);
  }

  /** The second object moved along x or y until it is near the first one, at the nearest step. */
  private Slide beside(Slide first, Slide second) {
    boolean alongX = random.nextBoolean();
    double wanted = random.nextDouble(MIN_BESIDE_GAP_PX, MAX_BESIDE_GAP_PX) * factor;
    double overlap = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < CompositeSource.STEPS; i++) {
      Box a = first.box(i);
      Box b = second.box(i);
      overlap = Math.max(overlap, alongX ? a.x1() - b.x0() : a.y1() - b.y0());
    }
    double move = overlap + wanted;
    return new Slide(
        second.source,
        second.sx,
        second.sy,
        second.x + (alongX ? move : 0),
        second.y + (alongX ? 0 : move),
        second.vx,
        second.vy);
  }

  private boolean isAccepted(List<Slide> slides) {
    for (int k = 0; k < OBJECTS; k++) {
      for (int i = 0; i < CompositeSource.STEPS; i += 4) {
        if (visible(slides.get(k).box(i)) < 0.9) {
          return false;
        }
      }
    }
    double[][] gaps = new double[OBJECTS][];
    for (int k = 0; k < OBJECTS; k++) {
      gaps[k] = gaps(slides, k, (k + 1) % OBJECTS);
    }
    int rest = kind == Arrangement.APART ? 0 : 1;
    for (int k = rest; k < OBJECTS; k++) {
      if (minimum(gaps[k]) < MIN_APART_GAP_PX * factor) {
        return false;
      }
    }
    double[] pair = gaps[0];
    return switch (kind) {
      case APART -> true;
      case CROSSING ->
          minimum(pair) < 0
              && pair[0] > MIN_APART_GAP_PX * factor
              && pair[pair.length - 1] > MIN_APART_GAP_PX * factor;
      case BESIDE -> {
        double[] sorted = pair.clone();
        Arrays.sort(sorted);
        Box box = slides.get(0).box(0);
        yield sorted[0] > MIN_BESIDE_GAP_PX / 2.0
            && sorted[sorted.length / 2] < (box.width() + box.height()) / 2;
      }
    };
  }

  private static double minimum(double[] values) {
    return Arrays.stream(values).min().orElseThrow();
  }

  private double[] gaps(List<Slide> slides, int a, int b) {
    double[] gaps = new double[CompositeSource.STEPS];
    for (int i = 0; i < gaps.length; i++) {
      Box first = slides.get(a).box(i);
      gaps[i] = first.gapTo(slides.get(b).box(i));
    }
    return gaps;
  }

  /** Share of a box that is in the picture. */
  private double visible(Box box) {
    return box.shareIn(new Box(0, 0, geometry.width() - 1, geometry.height() - 1));
  }

  private Box clipped(Box box) {
    double x0 = Math.max(0, box.x0());
    double y0 = Math.max(0, box.y0());
    double x1 = Math.min(geometry.width() - 1, box.x1());
    double y1 = Math.min(geometry.height() - 1, box.y1());
    return x0 <= x1 && y0 <= y1 ? new Box(x0, y0, x1, y1) : null;
  }

  private ObjectScene scene(List<Slide> slides, String kindName, long seed) {
    List<TruthMoment> truth = new ArrayList<>();
    for (int i = 0; i < CompositeSource.STEPS; i++) {
      List<TrueObject> objects = new ArrayList<>();
      List<Box> ignored = new ArrayList<>();
      for (int k = 0; k < OBJECTS; k++) {
        CompositeSource source = sources.get(k);
        Box box = slides.get(k).box(i);
        if (source.boxes()[i] == null) {
          ignored.add(
              new Box(
                  box.x0() - UNKNOWN_PX,
                  box.y0() - UNKNOWN_PX,
                  box.x1() + UNKNOWN_PX,
                  box.y1() + UNKNOWN_PX));
        } else if (visible(box) < MIN_VISIBLE) {
          ignored.add(box);
        } else {
          objects.add(new TrueObject(k + 1, clipped(box)));
        }
      }
      truth.add(new TruthMoment(i * CompositeSource.STEP_US, objects, ignored));
    }
    EventList events = new EventList();
    for (int k = 0; k < OBJECTS; k++) {
      add(events, slides.get(k));
    }
    EventPacket packet = events.sorted(0, CompositeSource.DURATION_US);
    return new ObjectScene(
        "composite-" + kindName + "-" + seed,
        "composite " + kindName,
        () -> new MemoryRecording(geometry, packet),
        truth,
        Matching.BOX);
  }

  private void add(EventList events, Slide slide) {
    EventPacket source = slide.source.events();
    int copies = Math.max(1, (int) Math.round(Math.abs(slide.sx)));
    for (int i = 0; i < source.size(); i++) {
      double movingS = slide.source.movingS(source.timeUs(i));
      for (int c = 0; c < copies * copies; c++) {
        double dx = (c % copies + 0.5) / copies - 0.5;
        double dy = (c / copies + 0.5) / copies - 0.5;
        int x = (int) Math.round(slide.sx * (source.x(i) + dx) + slide.x(movingS));
        int y = (int) Math.round(slide.sy * (source.y(i) + dy) + slide.y(movingS));
        if (geometry.contains(x, y)) {
          long delayUs = copies == 1 ? 0 : random.nextInt(COPIES_WITHIN_US);
          events.add(source.timeUs(i) + delayUs, x, y, source.isOn(i));
        }
      }
    }
  }
}
