package haltere.testing.objects;

import haltere.core.event.EventPacket;
import haltere.core.stream.EventSource;
import haltere.testing.SceneEvents;
import java.io.IOException;
import java.util.List;
import java.util.stream.IntStream;

/**
 * How dense events are around moments of truth.
 *
 * @param inBoxes events for each pixel and moment in the boxes of objects
 * @param elsewhere the same in neither objects nor ignored regions
 */
record EventDensity(double inBoxes, double elsewhere) {
  private static final long NEAR_US = 20_000;

  static EventDensity of(ObjectScene scene) throws IOException {
    try (EventSource source = scene.events().open()) {
      return of(source.geometry().pixels(), SceneEvents.of(source), scene);
    }
  }

  private static EventDensity of(int pixels, EventPacket events, ObjectScene scene) {
    long inside = 0;
    long outside = 0;
    double area = 0;
    for (TruthMoment moment : scene.truth()) {
      List<Box> objects = moment.objects().stream().map(TrueObject::box).toList();
      for (int i : near(events, moment)) {
        int x = events.x(i);
        int y = events.y(i);
        if (isInOne(objects, x, y)) {
          inside++;
        } else if (!isInOne(moment.ignored(), x, y)) {
          outside++;
        }
      }
      area += objects.stream().mapToDouble(box -> (box.width() + 1) * (box.height() + 1)).sum();
    }
    // Overlaps and ignored regions make both areas too large, so densities are too small.
    return new EventDensity(
        inside / area, outside / Math.max(1, (double) pixels * scene.truth().size() - area));
  }

  /** Indexes of the events around a moment. */
  static int[] near(EventPacket events, TruthMoment moment) {
    return IntStream.range(
            events.indexAtOrAfter(moment.timeUs() - NEAR_US),
            events.indexAtOrAfter(moment.timeUs() + NEAR_US))
        .toArray();
  }

  private static boolean isInOne(List<Box> boxes, int x, int y) {
    for (Box box : boxes) {
      if (box.contains(x, y, 0.5)) {
        return true;
      }
    }
    return false;
  }

  double ratio() {
    return inBoxes / elsewhere;
  }
}
