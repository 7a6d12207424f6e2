package haltere.core.simulation.internal.road;

import haltere.core.simulation.internal.road.PaintedBox.Ray;
import java.util.ArrayList;
import java.util.List;

/**
 * Computes the rows of ground truth of a road.
 *
 * <p>Thread rule: any thread.
 */
final class RoadTruthRows {
  private static final int SAMPLES = 24;

  /** Margin around the box of a vehicle, far above rounding errors. */
  private static final double MARGIN_PX = 1;

  private static final double DIFFERENCE_S = 1e-4;
  private static final double US = 1e-6;

  private final RoadSceneSettings settings;
  private final RoadCamera camera;
  private final TrafficPlan plan;

  RoadTruthRows(RoadSceneSettings settings, RoadCamera camera, TrafficPlan plan) {
    this.settings = settings;
    this.camera = camera;
    this.plan = plan;
  }

  /** A vehicle at a time. */
  private record VisibleVehicle(Vehicle vehicle, double x, double near, RoadView view) {
    boolean mayHide(VisibleVehicle other) {
      return other != this
          && !(view.toX < other.view.fromX - MARGIN_PX
              || view.fromX > other.view.toX + MARGIN_PX
              || view.toY < other.view.fromY - MARGIN_PX
              || view.fromY > other.view.toY + MARGIN_PX);
    }

    double intersect(Ray ray) {
      double nearest = PaintedBox.NOWHERE;
      for (int i = 0; i < vehicle.parts.size(); i++) {
        nearest = Math.min(nearest, vehicle.parts.get(i).intersect(x, near, ray));
      }
      return nearest;
    }
  }

  List<RoadTruth> rows(long timeUs) {
    double seconds = (timeUs - settings.run().startUs()) * US;
    List<Vehicle> there = new ArrayList<>();
    plan.collect(seconds, there);
    List<VisibleVehicle> seen = new ArrayList<>(there.size());
    for (Vehicle vehicle : there) {
      VisibleVehicle here =
          new VisibleVehicle(vehicle, vehicle.x(seconds), vehicle.near(seconds), new RoadView());
      here.view.see(camera, vehicle, here.x, here.near);
      seen.add(here);
    }
    List<RoadTruth> rows = new ArrayList<>(there.size());
    for (VisibleVehicle each : seen) {
      if (each.view.touches(settings.sensor())) {
        rows.add(row(timeUs, seconds, each, seen));
      }
    }
    return rows;
  }

  private RoadTruth row(
      long timeUs, double seconds, VisibleVehicle seen, List<VisibleVehicle> all) {
    Vehicle vehicle = seen.vehicle;
    double width = seen.view.toX - seen.view.fromX;
    double height = seen.view.toY - seen.view.fromY;
    double visible = visibleShare(seen, all);
    double column = (seen.view.fromX + seen.view.toX) / 2;
    double row = (seen.view.fromY + seen.view.toY) / 2;
    RoadView view = new RoadView();
    double[] before = centre(vehicle, seconds - DIFFERENCE_S, view);
    double[] after = centre(vehicle, seconds + DIFFERENCE_S, view);
    double perS = 1 / (2 * DIFFERENCE_S);
    double x = seen.x;
    return new RoadTruth(
        timeUs,
        vehicle.id,
        vehicle.kind,
        lane(x),
        x,
        seen.near + vehicle.lengthM / 2,
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

  private double visibleShare(VisibleVehicle seen, List<VisibleVehicle> all) {
    List<VisibleVehicle> before = new ArrayList<>();
    for (VisibleVehicle other : all) {
      if (other.mayHide(seen)) {
        before.add(other);
      }
    }
    RoadView view = seen.view;
    boolean entire =
        before.isEmpty() && isOnSensor(view.fromX, view.fromY) && isOnSensor(view.toX, view.toY);
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
        double range = seen.intersect(ray);
        if (range < PaintedBox.NOWHERE) {
          if (entire) {
            return 1;
          }
          own++;
          visible += isOnSensor(column, row) && !isHidden(range, before, ray) ? 1 : 0;
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

  private static boolean isHidden(double range, List<VisibleVehicle> before, Ray ray) {
    for (int i = 0; i < before.size(); i++) {
      if (before.get(i).intersect(ray) < range) {
        return true;
      }
    }
    return false;
  }
}
