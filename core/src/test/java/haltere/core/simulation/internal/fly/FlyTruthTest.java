package haltere.core.simulation.internal.fly;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.simulation.SceneRuns;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The truth of the fly matches its definitions. */
class FlyTruthTest {
  private static final String[] STEADY = {
    "stroke.beat.frequencySdHz=0", "stroke.beat.amplitudeSdRad=0"
  };

  private static FlyScene steady(String... assignments) {
    return new FlyScene(SceneRuns.pure(STEADY).with(assignments));
  }

  @Test
  void anglesAndPhasesLieInTheirRanges() {
    FlyScene scene =
        new FlyScene(SceneRuns.fly("stroke.left.amplitudeRad=1.5", "stroke.left.centreRad=0.7"));

    for (long us = 0; us < 2_000_000; us += 777) {
      FlyTruth truth = scene.truthAt(us);
      for (FlyTruth.Wing wing : new FlyTruth.Wing[] {truth.left(), truth.right()}) {
        for (double angle :
            new double[] {
              wing.angleRad(), wing.leadingRad(), wing.trailingRad(), wing.phaseRad()
            }) {
          assertTrue(angle >= 0 && angle < 2 * Math.PI, wing.toString());
        }
      }
      assertTrue(truth.headingRad() >= 0 && truth.headingRad() < 2 * Math.PI);
    }
  }

  @Test
  void amplitudeIsHalfOfPeakToPeakAndCentreIsTheMeanOverABeat() {
    FlyScene scene = steady("stroke.beat.frequencyHz=200");
    double least = 10;
    double most = 0;
    double sum = 0;
    for (int us = 0; us < 5000; us++) {
      double angle = scene.truthAt(us).leftAngleRad();
      least = Math.min(least, angle);
      most = Math.max(most, angle);
      sum += angle;
    }
    FlyTruth truth = scene.truthAt(0);

    assertEquals((most - least) / 2, truth.leftAmplitudeRad(), 1e-6);
    assertEquals(sum / 5000, truth.leftCentreRad(), 1e-9);
    assertEquals(1.15, truth.leftAmplitudeRad());
    assertEquals(1.72, truth.leftCentreRad());
  }

  @Test
  void phaseIsZeroAtThePassageOfTheCentreTowardsTheTail() {
    FlyScene scene = steady();
    FlyTruth before = scene.truthAt(0);
    int passages = 0;
    for (int us = 1; us < 50_000; us++) {
      FlyTruth truth = scene.truthAt(us);
      if (truth.leftPhaseRad() < before.leftPhaseRad()) {
        passages++;
        assertTrue(before.leftAngleRad() <= before.leftCentreRad());
        assertTrue(truth.leftAngleRad() >= truth.leftCentreRad());
      }
      before = truth;
    }

    assertEquals(10, passages);
  }

  @Test
  void phaseIsTheIntegralOfTheFrequencyEvenInManoeuvres() {
    FlyScene scene = new FlyScene(SceneRuns.fly("disturbances.manoeuvres.everyS=2"));
    ToDoubleFunction<FlyTruth> phase = FlyTruth::rightPhaseRad;
    ToDoubleFunction<FlyTruth> frequency = FlyTruth::rightFrequencyHz;
    double cycles = 0;
    double turned = 0;
    long step = 100;
    FlyTruth before = scene.truthAt(0);
    for (long us = step; us <= 13_000_000; us += step) {
      FlyTruth truth = scene.truthAt(us);
      double mean = (frequency.applyAsDouble(before) + frequency.applyAsDouble(truth)) / 2;
      cycles += mean * step * 1e-6;
      double turn = phase.applyAsDouble(truth) - phase.applyAsDouble(before);
      turned += (turn < 0 ? turn + 2 * Math.PI : turn) / (2 * Math.PI);
      before = truth;
    }

    assertEquals(cycles, turned, 1e-4);
  }

  @Test
  void frequencyHasItsMeanAndStandardDeviation() {
    FlyScene scene = new FlyScene(SceneRuns.fly("disturbances.manoeuvres.everyS=0", "run.seed=11"));
    int n = 20_000;
    double sum = 0;
    double square = 0;
    double amplitudeSquare = 0;
    for (int i = 0; i < n; i++) {
      FlyTruth truth = scene.truthAt(i * 50_000L);
      double frequency = truth.leftFrequencyHz();
      sum += frequency / n;
      square += frequency * frequency / n;
      amplitudeSquare += Math.pow(truth.leftAmplitudeRad() - 1.15, 2) / n;
    }

    assertEquals(200, sum, 0.1);
    assertEquals(4.8, Math.sqrt(square - sum * sum), 0.1);
    assertEquals(Math.toRadians(2.7), Math.sqrt(amplitudeSquare), 0.001);
  }

  @Test
  void frequencyVariesSlowlyBetweenBeats() {
    FlyScene scene = new FlyScene(SceneRuns.fly("disturbances.manoeuvres.everyS=0"));
    for (int i = 0; i < 10_000; i++) {
      double now = scene.truthAt(i * 5_000L).leftFrequencyHz();
      double next = scene.truthAt((i + 1) * 5_000L).leftFrequencyHz();
      assertTrue(Math.abs(next - now) < 0.5, "from beat to beat");
    }
  }

  @Test
  void frequencyManoeuvreFollowsItsTimeConstant() {
    FlyScene scene = steady("disturbances.manoeuvres.everyS=3", "stroke.beat.frequencyHz=200");
    Manoeuvres manoeuvres =
        new Manoeuvres(scene.settings().disturbances().manoeuvres(), scene.settings().run().seed());
    double begin = manoeuvres.beginS(0);

    assertEquals(200, frequency(scene, begin), 1e-3);
    assertEquals(200 + 15 * (1 - Math.exp(-1)), frequency(scene, begin + 0.05), 1e-3);
    assertEquals(215, frequency(scene, begin + 0.4), 0.01);
    assertEquals(200 + 15 * Math.exp(-1), frequency(scene, begin + 0.45), 0.01);
    assertEquals(200, frequency(scene, begin + 1.2), 1e-4);
    assertEquals(215, frequency(scene, manoeuvres.beginS(3) + 0.4), 0.01);
  }

  private static double frequency(FlyScene scene, double seconds) {
    return scene.truthAt(Math.round(seconds * 1e6)).leftFrequencyHz();
  }

  @Test
  void amplitudeManoeuvresAreAntisymmetric() {
    FlyScene scene = steady("disturbances.manoeuvres.everyS=3");
    Manoeuvres manoeuvres = new Manoeuvres(scene.settings().disturbances().manoeuvres(), 1);
    FlyTruth held = scene.truthAt(Math.round((manoeuvres.beginS(1) + 0.4) * 1e6));

    double left = held.leftAmplitudeRad() - 1.15;
    double right = held.rightAmplitudeRad() - 1.1;
    assertEquals(0.14, Math.abs(left - right), 1e-3);
    assertEquals(0, left + right, 1e-12);
  }

  @Test
  void saccadesTurnTheHeadingWithin80MsAndAlternate() {
    FlyScene scene =
        steady("disturbances.manoeuvres.everyS=3", "disturbances.manoeuvres.turnRad=0.6");
    Manoeuvres manoeuvres = new Manoeuvres(scene.settings().disturbances().manoeuvres(), 1);
    double start = scene.truthAt(0).headingRad();
    double first = manoeuvres.beginS(2);
    double second = manoeuvres.beginS(5);

    assertEquals(0, SceneRuns.turn(start, heading(scene, first)), 1e-6);
    assertEquals(0.3, Math.abs(SceneRuns.turn(start, heading(scene, first + 0.04))), 1e-4);
    assertEquals(0.6, Math.abs(SceneRuns.turn(start, heading(scene, first + 0.081))), 1e-9);
    assertEquals(0.6, Math.abs(SceneRuns.turn(start, heading(scene, second))), 1e-6);
    assertEquals(0, SceneRuns.turn(start, heading(scene, second + 0.081)), 1e-9);
  }

  private static double heading(FlyScene scene, double seconds) {
    return scene.truthAt(Math.round(seconds * 1e6)).headingRad();
  }

  @Test
  void edgesDifferByTheWidthOfTheWing() {
    FlyScene scene = steady("fly.wing.widthRad=0.06");
    for (int us = 0; us < 10_000; us += 7) {
      FlyTruth.Wing now = scene.truthAt(us).right();
      double motion = scene.truthAt(us + 1).rightAngleRad() - now.angleRad();
      double ahead = now.leadingRad() - now.trailingRad();

      assertEquals(0.06, Math.abs(ahead), 1e-9);
      if (Math.abs(motion) > 1e-5) {
        assertEquals(Math.signum(motion), Math.signum(ahead));
      }
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 0.7, 1.9, 3.3, 5.9})
  void hingesLieAcrossTheHeadingAboutTheCentre(double heading) {
    FlyTruth truth =
        new FlyScene(SceneRuns.fly("fly.body.headingRad=" + heading, "fly.body.hingeOffsetPx=5"))
            .truthAt(123_456);

    double dx = truth.leftHingeXPx() - truth.rightHingeXPx();
    double dy = truth.leftHingeYPx() - truth.rightHingeYPx();
    assertEquals(10, Math.hypot(dx, dy), 1e-9);
    assertEquals(truth.centreXPx(), (truth.leftHingeXPx() + truth.rightHingeXPx()) / 2, 1e-9);
    assertEquals(truth.centreYPx(), (truth.leftHingeYPx() + truth.rightHingeYPx()) / 2, 1e-9);
    double leftwards = Math.atan2(dy, dx);
    assertEquals(
        Math.PI / 2, SceneRuns.turn(truth.headingRad(), leftwards), 1e-9, "left is leftwards");
  }

  @Test
  void phaseLagDelaysAWing() {
    FlyScene scene = steady("stroke.left.phaseLagRad=0", "stroke.right.phaseLagRad=0.3");
    FlyTruth truth = scene.truthAt(12_345);

    assertEquals(0.3, SceneRuns.turn(truth.rightPhaseRad(), truth.leftPhaseRad()), 1e-9);
  }

  @Test
  void frequencyOffsetChangesTheBeatOfAWing() {
    FlyScene scene = steady("stroke.left.frequencyOffsetHz=3");
    FlyTruth truth = scene.truthAt(12_345);

    assertEquals(3, truth.leftFrequencyHz() - truth.rightFrequencyHz(), 1e-9);
  }

  @Test
  void bodySwayHasTheStatedDeviation() {
    FlyScene scene = new FlyScene(SceneRuns.fly("fly.body.wobblePx=0.5", "fly.body.driftPx=2"));
    int n = 20_000;
    double square = 0;
    for (int i = 0; i < n; i++) {
      square += Math.pow(scene.truthAt(i * 50_000L).centreXPx() - 63.5, 2) / n;
    }

    assertEquals(0.5 * 0.5 + 2 * 2, square, 0.3);
  }

  @Test
  void clapBringsTheWingsTogetherBehindTheBody() {
    FlyScene scene = new FlyScene(SceneRuns.pure("stroke.beat.clapAndFling=true"));
    double most = 0;
    for (int us = 0; us < 20_000; us++) {
      most = Math.max(most, scene.truthAt(us).leftAngleRad());
    }

    assertEquals(Math.PI - FlyKinematics.CLAP_GAP, most, 1e-3);
  }

  @Test
  void truthDoesNotDependOnPulledEvents() {
    FlyScene fresh = new FlyScene(SceneRuns.fly("run.durationS=0.1"));
    FlyScene pulled = new FlyScene(SceneRuns.fly("run.durationS=0.1"));
    SceneRuns.events(pulled);

    assertEquals(fresh.truthAt(54_321), pulled.truthAt(54_321));
    assertEquals(fresh.truthAt(1_000), pulled.truthAt(1_000));
  }
}
