package haltere.testing.objects;

import haltere.testing.MemoryRecording;
import haltere.testing.evaluation.ObjectPoint;
import haltere.testing.evaluation.TrackingScene;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** The discs of {@link TrackingScene} as scenes of objects. */
final class Discs {
  private Discs() {}

  static ObjectScene scene(long seed) {
    TrackingScene scene = TrackingScene.of(seed);
    Map<Long, List<TrueObject>> objects = new TreeMap<>();
    Map<Long, List<Box>> ignored = new TreeMap<>();
    for (long timeUs : scene.timesUs()) {
      objects.put(timeUs, new ArrayList<>());
      ignored.put(timeUs, new ArrayList<>());
    }
    for (ObjectPoint p : scene.truth()) {
      objects.get(p.timeUs()).add(new TrueObject(p.id(), around(p), p.vx(), p.vy()));
    }
    scene.halfSeen().forEach(p -> ignored.get(p.timeUs()).add(around(p)));
    List<TruthMoment> truth = new ArrayList<>();
    objects.forEach((t, there) -> truth.add(new TruthMoment(t, there, ignored.get(t))));
    return new ObjectScene(
        "discs-" + seed,
        "discs",
        () -> new MemoryRecording(scene.geometry(), scene.events()),
        truth,
        Matching.GATE);
  }

  private static Box around(ObjectPoint point) {
    return Box.around(point.x(), point.y(), Matching.GATE_PX, Matching.GATE_PX);
  }
}
