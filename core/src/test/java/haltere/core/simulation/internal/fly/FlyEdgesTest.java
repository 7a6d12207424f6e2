package haltere.core.simulation.internal.fly;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.simulation.SceneRuns;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Positions of wing events compared with the true edges. */
class FlyEdgesTest {
  @ParameterizedTest
  @ValueSource(doubles = {0, 1.0, 2.5, 4.4})
  void idealEventsLieOnEdgesThroughTheHinge(double heading) {
    Residuals residuals =
        residuals(
            SceneRuns.pure("fly.body.headingRad=" + heading, "fly.wing.visibleShare=0.2"), 0.05, 0);

    assertTrue(residuals.events > 20_000, residuals.toString());
    assertEquals(0, residuals.mean(), 2e-5, "mean");
    // time stamps are whole microseconds, in which the edge moves by up to 1.5 mrad
    assertTrue(residuals.rms() < 4.5e-4, residuals.toString());
    assertTrue(residuals.worst < 9e-4, residuals.toString());
  }

  @Test
  void idealEventsFollowTheEdgesOfAMovingBody() {
    Residuals residuals =
        residuals(
            SceneRuns.pure(
                "fly.body.wobblePx=0.5",
                "fly.body.driftPx=1",
                "disturbances.manoeuvres.everyS=1",
                "disturbances.manoeuvres.turnRad=0.6",
                "disturbances.manoeuvres.holdS=0.05",
                "disturbances.manoeuvres.timeConstantS=0.01",
                "fly.wing.visibleShare=0.01"),
            3,
            0);

    assertEquals(0, residuals.mean(), 2e-4, "mean");
    assertTrue(residuals.rms() < 2e-3, residuals.toString());
    // at a reversal the body's own motion can carry a pixel over the edge that is behind
    assertTrue(residuals.far < 1e-3 * residuals.events, residuals.toString());
  }

  @Test
  void constantLatencyIsARemovablePhaseLag() {
    FlySceneSettings settings = SceneRuns.pure("pixel.latencyUs=60", "fly.wing.visibleShare=0.2");

    assertEquals(0, residuals(settings, 0.05, 60).mean(), 2e-5, "mean");
    assertEquals(0, residuals(settings, 0.05, 60).rms(), 4.5e-4, "rms");
    // 60 us at 200 Hz are 4.3 degrees of phase: with an amplitude of 1.15, up to 0.087 rad
    assertEquals(0.06, residuals(settings, 0.05, 0).rms(), 0.01);
  }

  @Test
  void leadingEdgeMakesOffEventsAndTrailingEdgeOnEvents() {
    FlyScene scene = new FlyScene(SceneRuns.pure("run.durationS=0.05", "fly.wing.widthRad=0.1"));
    EventPacket events = SceneRuns.events(scene);
    for (int i = 0; i < events.size(); i++) {
      FlyTruth truth = scene.truthAt(events.timeUs(i));
      boolean left = SceneRuns.isLeft(truth, events.x(i), events.y(i));
      FlyTruth.Wing wing = left ? truth.left() : truth.right();
      double angle = SceneRuns.strokeAngle(truth, left, events.x(i), events.y(i));
      double fromLeading = Math.abs(SceneRuns.turn(wing.leadingRad(), angle));
      double fromTrailing = Math.abs(SceneRuns.turn(wing.trailingRad(), angle));

      assertEquals(fromTrailing < fromLeading, events.isOn(i));
    }
  }

  @Test
  void wingEventsLieBetweenRootAndTip() {
    FlyScene scene = new FlyScene(SceneRuns.pure("run.durationS=0.02", "fly.wing.lengthPx=30"));
    EventPacket events = SceneRuns.events(scene);
    for (int i = 0; i < events.size(); i++) {
      FlyTruth truth = scene.truthAt(events.timeUs(i));
      boolean left = SceneRuns.isLeft(truth, events.x(i), events.y(i));
      double radius =
          left
              ? Math.hypot(events.x(i) - truth.leftHingeXPx(), events.y(i) - truth.leftHingeYPx())
              : Math.hypot(
                  events.x(i) - truth.rightHingeXPx(), events.y(i) - truth.rightHingeYPx());
      assertTrue(radius >= 9 && radius <= 30, "radius " + radius);
    }
  }

  private static Residuals residuals(FlySceneSettings settings, double seconds, double latencyUs) {
    FlyScene scene = new FlyScene(settings.with("run.durationS=" + seconds));
    EventPacket events = SceneRuns.events(scene);
    Residuals residuals = new Residuals();
    for (int i = 0; i < events.size(); i++) {
      long us = (long) (events.timeUs(i) - latencyUs);
      FlyTruth before = scene.truthAt(us);
      FlyTruth after = scene.truthAt(us + 1);
      boolean left = SceneRuns.isLeft(before, events.x(i), events.y(i));
      if (isTowardsTail(scene, us - 10, left) == isTowardsTail(scene, us + 11, left)) {
        // not at a reversal, where the edges change sides
        double angle = SceneRuns.strokeAngle(before, left, events.x(i), events.y(i));
        residuals.add(before, after, left, events.isOn(i), angle);
      }
    }
    return residuals;
  }

  private static boolean isTowardsTail(FlyScene scene, long timeUs, boolean left) {
    FlyTruth truth = scene.truthAt(timeUs);
    FlyTruth.Wing wing = left ? truth.left() : truth.right();
    return wing.leadingRad() > wing.trailingRad();
  }

  /** Angle of an event less that of its edge in the middle of its microsecond. */
  private static final class Residuals {
    private int events;
    private double sum;
    private double square;
    private double worst;
    private int far;

    void add(FlyTruth before, FlyTruth after, boolean left, boolean on, double angle) {
      FlyTruth.Wing a = left ? before.left() : before.right();
      FlyTruth.Wing b = left ? after.left() : after.right();
      double edgeA = on ? a.trailingRad() : a.leadingRad();
      double edgeB = on ? b.trailingRad() : b.leadingRad();
      double residual = SceneRuns.turn((edgeA + edgeB) / 2, angle);
      // signed in the direction of motion, so that a lag does not cancel
      double signed = residual * Math.signum(a.leadingRad() - a.trailingRad());
      events++;
      sum += signed;
      square += residual * residual;
      worst = Math.max(worst, Math.abs(residual));
      far += Math.abs(residual) > 0.01 ? 1 : 0;
    }

    double mean() {
      return sum / events;
    }

    double rms() {
      return Math.sqrt(square / events);
    }

    @Override
    public String toString() {
      return events
          + " events, mean "
          + mean()
          + ", rms "
          + rms()
          + ", worst "
          + worst
          + ", far "
          + far;
    }
  }
}
