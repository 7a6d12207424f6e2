package haltere.filters.orientation.line;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.EventFilter;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.simulation.internal.flight.FlightScene;
import haltere.core.simulation.internal.flight.FlightSettings;
import haltere.core.simulation.internal.flight.FlightTruth;
import haltere.filters.estimation.Angles;
import haltere.filters.orientation.EventFlights;
import haltere.filters.orientation.FlightScores;
import haltere.filters.orientation.Flights;
import haltere.filters.orientation.camera.CameraModel;
import haltere.testing.EventFilterContract;
import haltere.testing.SceneEvents;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class BodyLineFilterTest extends EventFilterContract {
  @Override
  protected EventFilter create(SensorGeometry geometry) {
    return new BodyLineFilter(geometry, BodyLineSettings.defaults());
  }

  @Override
  protected EventPacket stream(SensorGeometry geometry, long seed) {
    return SceneEvents.of(
        new FlightScene(
            FlightSettings.defaults()
                .with(
                    "sensor.widthPx=" + Math.max(16, geometry.width()),
                    "sensor.heightPx=" + Math.max(16, geometry.height()),
                    "body.lengthM=0.05",
                    "body.widthM=0.02",
                    "body.speedMS=0.6",
                    "run.durationS=0.5",
                    "run.seed=" + seed)));
  }

  @Test
  void lineOfABodyIsEstimatedFromItsEvents() {
    List<Double> angles = new ArrayList<>();
    List<Double> positions = new ArrayList<>();
    List<Double> ratios = new ArrayList<>();
    for (long seed = 1; seed <= 3; seed++) {
      FlightScene scene = Flights.scene(2, seed, "run.durationS=2", "body.saccadesPerS=0.5");
      CameraModel camera = Flights.cameras(scene).get(0);
      BodyLineFilter filter = new BodyLineFilter(scene.geometry(), BodyLineSettings.defaults());
      filter
          .lines()
          .subscribe(
              line -> {
                FlightTruth truth = scene.truthAt(line.timeUs());
                double[] at = {truth.xM(), truth.yM(), truth.zM()};
                double[] axis = {truth.ux(), truth.uy(), truth.uz()};
                double[] pixel = new double[2];
                camera.project(at, pixel);
                double angle = camera.heading(at, axis);
                if (line.eccentricity() > 1.5) {
                  angles.add(Math.toDegrees(Math.abs(Angles.wrapHalfPi(line.angleRad() - angle))));
                }
                positions.add(Math.hypot(line.xPx() - pixel[0], line.yPx() - pixel[1]));
                ratios.add(line.eccentricity());
              });
      filter.process(SceneEvents.of(scene));
    }
    assertTrue(positions.size() > 600, positions.size() + " lines");
    assertTrue(
        FlightScores.quantile(positions, 0.5) < 1,
        "place " + FlightScores.quantile(positions, 0.5));
    assertTrue(
        FlightScores.quantile(angles, 0.5) < 4, "angle " + FlightScores.quantile(angles, 0.5));
    assertTrue(FlightScores.quantile(ratios, 0.9) > 1.8);
  }

  @Test
  void twoEventCamerasYieldTheOrientationOfABody() {
    List<Double> errors = new ArrayList<>();
    for (long seed = 11; seed <= 13; seed++) {
      errors.addAll(EventFlights.errorsDeg(2, seed, 2));
    }
    assertTrue(errors.size() > 600, errors.size() + " estimates");
    double median = FlightScores.quantile(errors, 0.5);
    assertTrue(median < 6, "median " + median);
    long wrong = errors.stream().filter(error -> error > 90).count();
    assertTrue(wrong < 0.02 * errors.size(), wrong + " the wrong way round");
  }

  @Test
  void ellipseIsEstimatedForAnyDirectionOfMotion() {
    SensorGeometry sensor = new SensorGeometry(200, 200);
    for (int degrees = 0; degrees < 180; degrees += 30) {
      List<BodyLine> lines = new ArrayList<>();
      BodyLineTracker tracker =
          new BodyLineTracker(
              sensor, BodyLineSettings.defaults().with("eventsPerOutlinePx=3"), lines::add);
      tracker.track(ellipse(18, 7, Math.toRadians(40), Math.toRadians(degrees)));
      BodyLine last = lines.get(lines.size() - 1);
      double off = Angles.wrapHalfPi(last.angleRad() - Math.toRadians(40));
      assertEquals(0, Math.toDegrees(off), 4, "moving at " + degrees);
      assertEquals(18, last.halfLengthPx(), 2.5, "moving at " + degrees);
      assertEquals(7, last.halfWidthPx(), 2, "moving at " + degrees);
    }
  }

  /** Crossings of an ellipse's outline at 400 px/s through the middle, without noise. */
  private static EventPacket ellipse(double a, double b, double angle, double direction) {
    EventPacket packet = new EventPacket(0);
    double cos = Math.cos(angle);
    double sin = Math.sin(angle);
    boolean[] inside = new boolean[200 * 200];
    for (int timeUs = 0; timeUs < 250_000; timeUs += 100) {
      double way = (timeUs - 125_000) * 1e-6 * 400;
      double x = 100 + way * Math.cos(direction);
      double y = 100 + way * Math.sin(direction);
      for (int py = (int) y - 20; py <= y + 20; py++) {
        for (int px = (int) x - 20; px <= x + 20; px++) {
          double along = (cos * (px - x) + sin * (py - y)) / a;
          double across = (cos * (py - y) - sin * (px - x)) / b;
          boolean now = along * along + across * across < 1;
          if (now != inside[200 * py + px]) {
            inside[200 * py + px] = now;
            packet.append(timeUs, px, py, !now);
          }
        }
      }
    }
    return packet;
  }
}
