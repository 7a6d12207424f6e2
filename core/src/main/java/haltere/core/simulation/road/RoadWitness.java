package haltere.core.simulation.road;

import haltere.core.simulation.road.PaintedBox.Ray;
import java.util.ArrayList;
import java.util.List;

/**
 * The ground truth of a road.
 *
 * <p>Thread rule: any thread.
 */
final class RoadWitness {
  private static final int SAMPLES = 24;
  private static final double DIFFERENCE_S = 1e-4;
  private static final double US = 1e-6;

  private final RoadSceneSettings settings;
  private final RoadCamera camera;
  private final TrafficPlan plan;

  RoadWitness(RoadSceneSettings settings, RoadCamera camera, TrafficPlan plan) {
    this.settings = settings;
    this.camera = camera;
    this.plan = plan;
  }

  List<RoadTruth> rows(long timeUs) {
    double seconds = (timeUs - settings.run().startUs()) * US;
    List<Vehicle> there = new ArrayList<>();
    plan.collect(seconds, there);
    List<RoadTruth> rows = new ArrayList<>(there.size());
    RoadView view = new RoadView();
    for (Vehicle vehicle : there) {
      view.see(camera, vehicle, vehicle.x(seconds), vehicle.near(seconds));
      if (view.touches(settings.sensor())) {
        rows.add(row(timeUs, seconds, vehicle, there, view));
      }
    }
    return rows;
  }

  private RoadTruth row(
      long timeUs, double seconds, Vehicle vehicle, List<Vehicle> there, RoadView view) {
    double width = view.toX - view.fromX;
    double height = view.toY - view.fromY;
    double visible = visibleShare(seconds, vehicle, there, view);
    double column = (view.fromX + view.toX) / 2;
    double row = (view.fromY + view.toY) / 2;
    double[] before = centre(vehicle, seconds - DIFFERENCE_S, view);
    double[] after = centre(vehicle, seconds + DIFFERENCE_S, view);
    double perS = 1 / (2 * DIFFERENCE_S);
    double x = vehicle.x(seconds);
    return new RoadTruth(
        timeUs,
        vehicle.id,
        vehicle.kind,
        lane(x),
        x,
        vehicle.near(seconds) + vehicle.lengthM / 2,
        vehicle.speedX(seconds),
        vehicle.speedY(seconds),
        column,
        row,
        (after[0] - before[0]) * perS,
        (after[1] - before[1]) * perS,
        width,
        height,
        visible,
        camera.groundX(column, row),
        camera.groundDistance(row),
        (camera.groundX(after[0], after[1]) - camera.groundX(before[0], before[1])) * perS,
        (camera.groundDistance(after[1]) - camera.groundDistance(before[1])) * perS);
  }

  private double[] centre(Vehicle vehicle, double seconds, RoadView view) {
    view.see(camera, vehicle, vehicle.x(seconds), vehicle.near(seconds));
    return new double[] {(view.fromX + view.toX) / 2, (view.fromY + view.toY) / 2};
  }

  private int lane(double x) {
    TrafficSettings traffic = settings.traffic();
    int lane = (int) Math.floor(x / traffic.laneWidthM()) + traffic.lanesTowards();
    return Math.max(0, Math.min(traffic.lanesAway() + traffic.lanesTowards() - 1, lane));
  }

  private double visibleShare(double seconds, Vehicle vehicle, List<Vehicle> there, RoadView view) {
    Ray ray = new Ray(camera.heightM);
    int own = 0;
    int visible = 0;
    for (int i = 0; i < SAMPLES; i++) {
      double row = view.fromY + (i + 0.5) / SAMPLES * (view.toY - view.fromY);
      double angle = camera.angle(row);
      if (angle <= 0) {
        break;
      }
      ray.inverseCos = 1 / StrictMath.cos(angle);
      ray.inverseSin = 1 / StrictMath.sin(angle);
      for (int j = 0; j < SAMPLES; j++) {
        double column = view.fromX + (j + 0.5) / SAMPLES * (view.toX - view.fromX);
        ray.tangent = camera.tangent(column);
        ray.inverseTangent = ray.tangent == 0 ? RoadPainter.STEEP : 1 / ray.tangent;
        double range = meet(vehicle, seconds, ray);
        if (range < PaintedBox.NOWHERE) {
          own++;
          visible +=
              isOnSensor(column, row) && !isHidden(range, vehicle, seconds, there, ray) ? 1 : 0;
        }
      }
    }
    return own == 0 ? 0 : (double) visible / own;
  }

  private boolean isOnSensor(double column, double row) {
    return column > -0.5
        && column < settings.sensor().widthPx() - 0.5
        && row > -0.5
        && row < settings.sensor().heightPx() - 0.5;
  }

  private static double meet(Vehicle vehicle, double seconds, Ray ray) {
    double x = vehicle.x(seconds);
    double near = vehicle.near(seconds);
    double nearest = PaintedBox.NOWHERE;
    for (PaintedBox part : vehicle.parts) {
      nearest = Math.min(nearest, part.meet(x, near, ray));
    }
    return nearest;
  }

  private static boolean isHidden(
      double range, Vehicle vehicle, double seconds, List<Vehicle> there, Ray ray) {
    for (Vehicle other : there) {
      if (other != vehicle && meet(other, seconds, ray) < range) {
        return true;
      }
    }
    return false;
  }
}
