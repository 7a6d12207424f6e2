package haltere.filters.object;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.testing.EventList;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.DoubleFunction;

/** Seeded events of shapes that move before noise. */
final class MovingShapes {
  /** Position of a shape at a time; null without events. */
  record Place(double x, double y) {}

  private record Shape(
      DoubleFunction<Place> path,
      double halfWidth,
      double halfHeight,
      double rateHz,
      double turnRadS) {}

  private final SensorGeometry sensor;
  private final SplittableRandom random;
  private final List<Shape> shapes = new ArrayList<>();
  private double noiseHz;

  MovingShapes(SensorGeometry sensor, long seed) {
    this.sensor = sensor;
    random = new SplittableRandom(seed);
  }

  /** Adds a filled box whose pixels fire at random. */
  MovingShapes box(double halfWidth, double halfHeight, double rateHz, DoubleFunction<Place> path) {
    return box(halfWidth, halfHeight, rateHz, 0, path);
  }

  /** Adds a filled box that turns as well. */
  MovingShapes box(
      double halfWidth,
      double halfHeight,
      double rateHz,
      double turnRadS,
      DoubleFunction<Place> path) {
    shapes.add(new Shape(path, halfWidth, halfHeight, rateHz, turnRadS));
    return this;
  }

  MovingShapes noise(double hertzPerPixel) {
    noiseHz = hertzPerPixel;
    return this;
  }

  /** Events of a time from the start, in order. */
  EventPacket events(double durationS) {
    EventList events = new EventList();
    double stepS = 1e-4;
    for (int step = 0; step < durationS / stepS; step++) {
      double s = step * stepS;
      for (Shape shape : shapes) {
        Place place = shape.path.apply(s);
        for (int n = place == null ? 0 : count(shape.rateHz * stepS); n > 0; n--) {
          double at = s + stepS * random.nextDouble();
          double dx = shape.halfWidth * (2 * random.nextDouble() - 1);
          double dy = shape.halfHeight * (2 * random.nextDouble() - 1);
          double cos = Math.cos(shape.turnRadS * s);
          double sin = Math.sin(shape.turnRadS * s);
          add(events, at, place.x() + cos * dx - sin * dy, place.y() + sin * dx + cos * dy);
        }
      }
      for (int n = count(noiseHz * sensor.pixels() * stepS); n > 0; n--) {
        add(
            events,
            s + stepS * random.nextDouble(),
            random.nextDouble(sensor.width()) - 0.5,
            random.nextDouble(sensor.height()) - 0.5);
      }
    }
    return events.sorted(0, Math.round(durationS * 1e6));
  }

  private int count(double expected) {
    int whole = (int) expected;
    return whole + (random.nextDouble() < expected - whole ? 1 : 0);
  }

  private void add(EventList events, double s, double x, double y) {
    int column = (int) Math.round(x);
    int row = (int) Math.round(y);
    if (column >= 0 && row >= 0 && column < sensor.width() && row < sensor.height()) {
      events.add(Math.round(s * 1e6), column, row, random.nextBoolean());
    }
  }
}
