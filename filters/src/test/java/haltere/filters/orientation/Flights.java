package haltere.filters.orientation;

import haltere.core.simulation.internal.flight.FlightCamera;
import haltere.core.simulation.internal.flight.FlightDetection;
import haltere.core.simulation.internal.flight.FlightScene;
import haltere.core.simulation.internal.flight.FlightSettings;
import haltere.filters.orientation.camera.CameraModel;
import haltere.filters.orientation.camera.LineObservation;
import java.util.ArrayList;
import java.util.List;

/** Simulated flights as the estimator takes them. */
public final class Flights {
  private Flights() {}

  public static FlightScene scene(int cameras, long seed, String... assignments) {
    return new FlightScene(
        FlightSettings.defaults()
            .with("view.cameras=" + cameras, "run.seed=" + seed)
            .with(assignments));
  }

  public static List<CameraModel> cameras(FlightScene scene) {
    return scene.cameras().stream().map(Flights::camera).toList();
  }

  static CameraModel camera(FlightCamera camera) {
    double[] matrix =
        camera.matrix().stream().flatMap(List::stream).mapToDouble(Double::doubleValue).toArray();
    return CameraModel.of(camera.id(), matrix, new double[0], camera.widthPx(), camera.heightPx());
  }

  static List<LineObservation> observations(FlightScene scene, List<FlightDetection> seen) {
    List<LineObservation> all = new ArrayList<>();
    for (FlightDetection each : seen) {
      int camera = 0;
      while (!scene.cameras().get(camera).id().equals(each.camera())) {
        camera++;
      }
      all.add(
          new LineObservation(
              camera, each.xPx(), each.yPx(), each.angleRad(), each.areaPx(), each.eccentricity()));
    }
    return all;
  }
}
