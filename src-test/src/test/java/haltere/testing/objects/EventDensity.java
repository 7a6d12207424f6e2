package haltere.testing.objects;

import haltere.core.event.EventPacket;
import haltere.core.stream.EventSource;
import haltere.testing.SceneEvents;
import java.io.IOException;

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
      for (int i = events.indexAtOrAfter(moment.timeUs() - NEAR_US);
          i < events.size() && events.timeUs(i) < moment.timeUs() + NEAR_US;
          i++) {
        int x = events.x(i);
        int y = events.y(i);
        if (moment.objects().stream().anyMatch(o -> o.box().contains(x, y, 0.5))) {
          inside++;
        } else if (moment.ignored().stream().noneMatch(box -> box.contains(x, y, 0.5))) {
          outside++;
        }
      }
      area +=
          moment.objects().stream()
              .mapToDouble(o -> (o.box().width() + 1) * (o.box().height() + 1))
              .sum();
    }
    // Overlaps and ignored regions make both areas too large, so densities are too small.
    return new EventDensity(
        inside / area, outside / Math.max(1, (double) pixels * scene.truth().size() - area));
  }

  double ratio() {
    return inBoxes / elsewhere;
  }
}
