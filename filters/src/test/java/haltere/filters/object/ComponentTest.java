package haltere.filters.object;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.filters.object.MovingShapes.Place;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

final class ComponentTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(64, 64);
  private static final int RUNS = 40;

  /** Follows a box in the middle that turns at once. */
  private static Component turning(double turnRadS, double halfHeight, long seed) {
    EventPacket events =
        new MovingShapes(SENSOR, seed)
            .box(8, halfHeight, 2_000, turnRadS, s -> new Place(32, 32))
            .events(1);
    ActivityGrid grid = new ActivityGrid(SENSOR);
    ClutterMap clutter = new ClutterMap(SENSOR, grid);
    BirthDetector births = new BirthDetector(grid, clutter);
    EventAssociation association = new EventAssociation(grid, clutter, births);
    Component component = new Component(0);
    component.begin(0, new MotionModel());
    component.state.setMean(0, 32);
    component.state.setMean(2, 32);
    component.state.setVariances(1, 1, 1, 1);
    component.rate = 20;
    component.shape.clear(ShapeTemplate.MIN_CELL_PX);
    component.shape.spread(0, 0, 20, 16);
    component.shape.refresh();
    new TrackedObject(component, 0);
    int next = 0;
    for (long tickUs = 0; tickUs < 1_000_000; tickUs += ObjectTracker.TICK_US) {
      for (; next < events.size() && events.timeUs(next) < tickUs + ObjectTracker.TICK_US; next++) {
        grid.add(events.x(next), events.y(next), (int) (events.timeUs(next) - tickUs));
      }
      clutter.begin(1);
      births.begin(1);
      association.associate(List.of(component));
      clutter.end();
      component.endTick(tickUs + ObjectTracker.TICK_US, 1);
      grid.next();
    }
    return component;
  }

  @Test
  void angularVelocityIsThatOfTheShape() {
    for (double turnRadS : new double[] {-3, -1, 0, 1, 3}) {
      double mean = 0;
      for (int seed = 0; seed < RUNS; seed++) {
        mean += turning(turnRadS, 1, seed).turn.mean(0) / RUNS;
      }
      // the smoothed template makes angles up to half as large again
      assertEquals(turnRadS, mean, 0.1 + 0.5 * Math.abs(turnRadS));
    }
  }

  @Test
  void errorsOfTheAngularVelocityAreAtMostAsStated() {
    SplittableRandom random = new SplittableRandom(1);
    for (double halfHeight : new double[] {1, 4, 8}) {
      double nees = 0;
      for (int seed = 0; seed < RUNS; seed++) {
        double turnRadS = random.nextDouble(-2, 2);
        Component component = turning(turnRadS, halfHeight, seed);
        double error = component.turn.mean(0) - turnRadS;
        nees += error * error / component.turn.covariance(0, 0) / RUNS;
      }
      // 95 % of a mean of so many squares (chi-square over its degrees of freedom)
      assertTrue(nees < 1.4, halfHeight + " px: " + nees);
    }
  }

  @Test
  void angularVelocityOfASquareIsLessCertainThanThatOfAnEdge() {
    assertTrue(turning(0, 8, 1).turnRadS() > turning(0, 1, 1).turnRadS());
  }
}
