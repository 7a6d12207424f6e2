package haltere.filters.orientation;

import haltere.core.simulation.internal.flight.FlightScene;
import haltere.core.simulation.internal.flight.FlightTruth;
import haltere.filters.orientation.camera.LineObservation;
import haltere.filters.orientation.camera.Vectors;
import haltere.filters.orientation.line.BodyLineSettings;
import haltere.filters.orientation.line.BodyLineTracker;
import haltere.testing.SceneEvents;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** From the events of several cameras to the orientation of the body that they see. */
public final class EventFlights {
  private EventFlights() {}

  /** Errors of the axis from 0.3 s on, degrees. */
  public static List<Double> errorsDeg(int cameras, long seed, double seconds) {
    Map<Long, List<LineObservation>> seen = new TreeMap<>();
    FlightScene scene = null;
    for (int index = 0; index < cameras; index++) {
      scene = Flights.scene(cameras, seed, "run.durationS=" + seconds, "view.camera=" + index);
      int camera = index;
      new BodyLineTracker(
              scene.geometry(),
              BodyLineSettings.defaults(),
              line ->
                  seen.computeIfAbsent(line.timeUs(), t -> new ArrayList<>())
                      .add(line.observation(camera)))
          .track(SceneEvents.of(scene));
    }
    BodyOrientationEstimator body =
        new BodyOrientationEstimator(Flights.cameras(scene), OrientationSettings.defaults());
    List<Double> errors = new ArrayList<>();
    for (Map.Entry<Long, List<LineObservation>> each : seen.entrySet()) {
      FlightTruth truth = scene.truthAt(each.getKey());
      body.update(each.getKey(), each.getValue())
          .filter(now -> now.timeUs() > 300_000)
          .ifPresent(
              now ->
                  errors.add(
                      Math.toDegrees(
                          Vectors.angle(
                              new double[] {now.ux(), now.uy(), now.uz()},
                              new double[] {truth.ux(), truth.uy(), truth.uz()}))));
    }
    return errors;
  }
}
