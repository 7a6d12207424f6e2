package haltere.core.simulation.internal.fly;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.settings.SettingsProblem;
import haltere.core.simulation.SceneRuns;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.testing.Allocation;
import haltere.testing.StreamRecorder;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The rendered fly: its images against its truth, and its events against its images. */
class RenderedFlySceneTest {
  /** Wings alone, without noise, before pixels without delay or mismatch. */
  private static final String[] PURE = {
    "pixel.bandwidthHz=0",
    "pixel.latencyUs=0",
    "pixel.jitterUs=0",
    "pixel.refractoryUs=0",
    "pixel.thresholdSd=0",
    "noise.leakHz=0",
    "noise.shotHz=0",
    "noise.hotPixels=0",
    "fly.wing.veins=0",
    "fly.body.contrast=0",
    "fly.body.wobblePx=0",
    "fly.body.driftPx=0",
    "fly.manoeuvres.everyS=0"
  };

  private static RenderedFlyScene pure(String... assignments) {
    return new RenderedFlyScene(RenderedFlySceneSettings.defaults().with(PURE).with(assignments));
  }

  private static RenderedFlyScene usual(String... assignments) {
    return new RenderedFlyScene(RenderedFlySceneSettings.defaults().with(assignments));
  }

  @Test
  void eventsAreReproducibleOnEveryMachine() {
    StreamRecorder events = SceneRuns.record(usual("run.durationS=0.02"));

    assertEquals("1f295588 of 18170", events.crc32() + " of " + events.events().size());
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 1000})
  void eventsDoNotDependOnPacketBoundaries(int maxEvents) {
    RenderedFlySceneSettings settings =
        RenderedFlySceneSettings.defaults().with("run.durationS=0.008");
    StreamRecorder cut = SceneRuns.record(new RenderedFlyScene(settings, maxEvents));

    assertEquals(SceneRuns.events(new RenderedFlyScene(settings)), cut.events());
    assertEquals(maxEvents, cut.largestPacket());
  }

  @Test
  void longerSceneStartsLikeAShorterOne() {
    EventPacket shorter = SceneRuns.events(usual("run.durationS=0.004"));
    EventPacket longer = SceneRuns.events(usual("run.durationS=0.006"));
    EventPacket begin = new EventPacket(shorter.size());
    begin.append(longer, 0, shorter.size());

    assertTrue(longer.size() > shorter.size());
    assertEquals(shorter, begin);
  }

  @Test
  void streamTakesConstantMemory() {
    RenderedFlyScene scene = usual("run.durationS=0.1");
    StreamRecorder first = new StreamRecorder();
    for (int i = 0; i < 20; i++) {
      scene.next(first);
    }
    StreamHandler nobody =
        new StreamHandler() {
          @Override
          public void packet(EventPacket packet) {}

          @Override
          public void notified(StreamNotification notification) {}
        };

    long bytes =
        Allocation.bytesOf(
            () -> {
              for (int i = 0; i < 5; i++) {
                scene.next(nobody);
              }
            });
    assertTrue(bytes < 20_000, bytes + " bytes");
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, 1.0, 2.5, 4.4})
  void truthIsTheLongAxisOfTheWingInTheImage(double heading) {
    RenderedFlyScene scene = pure("fly.body.headingRad=" + heading);
    for (long us = 0; us < 10_000; us += 470) {
      FlyTruth truth = scene.truthAt(us);
      double[] image = scene.imageAt(us);
      for (boolean left : new boolean[] {true, false}) {
        double angle = left ? truth.leftAngleRad() : truth.rightAngleRad();
        Moments moments = new Moments(truth, left, image);
        if (moments.dark > 20) {
          assertEquals(0, SceneRuns.turn(angle, moments.axis(angle)), 0.012, us + " us");
        }
      }
    }
  }

  /** Second moments of the dark pixels of a wing about its hinge. */
  private static final class Moments {
    final FlyTruth truth;
    final boolean left;
    double dark;
    double xx;
    double xy;
    double yy;

    Moments(FlyTruth truth, boolean left, double[] image) {
      this.truth = truth;
      this.left = left;
      double hingeX = left ? truth.leftHingeXPx() : truth.rightHingeXPx();
      double hingeY = left ? truth.leftHingeYPx() : truth.rightHingeYPx();
      for (int pixel = 0; pixel < image.length; pixel++) {
        double weight = 1 - image[pixel];
        double x = pixel % 128;
        double y = pixel / 128;
        if (weight > 0 && SceneRuns.isLeft(truth, x, y) == left) {
          dark += weight;
          xx += weight * (x - hingeX) * (x - hingeX);
          xy += weight * (x - hingeX) * (y - hingeY);
          yy += weight * (y - hingeY) * (y - hingeY);
        }
      }
    }

    /** Stroke angle of the axis of least second moment, the end of it that is nearer to one. */
    double axis(double near) {
      double direction = Math.atan2(2 * xy, xx - yy) / 2;
      double angle = left ? direction - truth.headingRad() : truth.headingRad() - direction;
      return Math.cos(angle - near) > 0 ? angle : angle + Math.PI;
    }
  }

  @Test
  void truthOfBothEdgesEnclosesTheDarkPixels() {
    RenderedFlyScene scene =
        pure("fly.wing.rootExponent=1", "fly.wing.tipExponent=0.1", "fly.wing.axisShare=0.25");
    for (long us = 0; us < 10_000; us += 470) {
      FlyTruth truth = scene.truthAt(us);
      double[] image = scene.imageAt(us);
      double low = Math.min(truth.leftLeadingRad(), truth.leftTrailingRad());
      double high = Math.max(truth.leftLeadingRad(), truth.leftTrailingRad());
      double dark = 0;
      double within = 0;
      for (int pixel = 0; pixel < image.length; pixel++) {
        double weight = 1 - image[pixel];
        if (weight > 0 && SceneRuns.isLeft(truth, pixel % 128, pixel / 128)) {
          double angle = SceneRuns.strokeAngle(truth, true, pixel % 128, pixel / 128);
          dark += weight;
          within += angle > low - 0.03 && angle < high + 0.03 ? weight : 0;
        }
      }
      // a wing that is nearly a sector
      assertTrue(within > 0.9 * dark, us + " us: " + within / dark);
      double area = (high - low) * 46 * 46 / 2 * 0.3;
      assertEquals(area, dark, 0.12 * area + 2, us + " us");
    }
  }

  @Test
  void apparentStrokeMatchesItsDefinitions() {
    RenderedFlyScene scene = pure("stroke.beat.frequencySdHz=0", "stroke.beat.amplitudeSdRad=0");
    double sum = 0;
    double least = 9;
    double most = 0;
    for (int us = 0; us < 5000; us++) {
      FlyTruth.Wing wing = scene.truthAt(us).left();
      sum += wing.angleRad() / 5000;
      least = Math.min(least, wing.angleRad());
      most = Math.max(most, wing.angleRad());
      FlyTruth.Wing next = scene.truthAt(us + 1).left();
      if (next.phaseRad() < wing.phaseRad()) {
        assertEquals(wing.centreRad(), wing.angleRad(), 2e-3);
        assertTrue(next.angleRad() > wing.angleRad());
      }
      assertEquals(wing.angleRad(), (wing.leadingRad() + wing.trailingRad()) / 2, 1e-9);
      boolean towardsTail = next.angleRad() > wing.angleRad();
      if (Math.abs(next.angleRad() - wing.angleRad()) > 1e-4) {
        assertEquals(towardsTail, wing.leadingRad() >= wing.trailingRad());
      }
    }
    FlyTruth.Wing wing = scene.truthAt(0).left();
    assertEquals(sum, wing.centreRad(), 1e-3);
    assertEquals((most - least) / 2, wing.amplitudeRad(), 1e-3);
  }

  @Test
  void brightnessOfAWingFollowsItsPitch() {
    RenderedFlyScene scene = pure("fly.pitch.flipAdvanceRad=0", "stroke.beat.waveform=sinusoid");
    double least = Double.POSITIVE_INFINITY;
    double most = 0;
    for (long us = 0; us < 5000; us += 20) {
      double dark = 0;
      for (double light : scene.imageAt(us)) {
        dark += (1 - light) / 0.3;
      }
      least = Math.min(least, dark);
      most = Math.max(most, dark);
    }
    assertTrue(least < 0.1 * most, least + " " + most);
    // chord 0.35 of the beta distribution with exponents 0.8 and 0.4, seen at 0.8 rad, twice
    assertEquals(2 * 0.35 * 46 * 46 * 0.7 * Math.cos(0.8), most, 0.12 * most);
  }

  @Test
  void frontEdgeMakesOffEventsAndRearEdgeOnEvents() {
    RenderedFlyScene scene = pure("run.durationS=0.02", "fly.wing.transmission=0.5");
    EventPacket events = SceneRuns.events(scene);
    int right = 0;
    int clear = 0;
    for (int i = 0; i < events.size(); i++) {
      FlyTruth truth = scene.truthAt(events.timeUs(i));
      boolean left = SceneRuns.isLeft(truth, events.x(i), events.y(i));
      FlyTruth.Wing wing = left ? truth.left() : truth.right();
      double angle = SceneRuns.strokeAngle(truth, left, events.x(i), events.y(i));
      // in mid stroke, where the edges are apart and move
      if (Math.abs(Math.cos(wing.phaseRad())) > 0.7) {
        double fromLeading = Math.abs(SceneRuns.turn(wing.leadingRad(), angle));
        double fromTrailing = Math.abs(SceneRuns.turn(wing.trailingRad(), angle));
        clear++;
        right += events.isOn(i) == fromTrailing < fromLeading ? 1 : 0;
      }
    }
    assertTrue(clear > 10_000, "" + clear);
    assertTrue(right > 0.97 * clear, right + " of " + clear);
  }

  @Test
  void slowerPixelsAndHigherThresholdsMakeFewerEvents() {
    int usual = count();
    assertTrue(count("pixel.bandwidthHz=500") < 0.5 * usual);
    assertTrue(count("pixel.threshold=0.6") < 0.5 * usual);
    assertTrue(count("fly.wing.transmission=0.4") > 1.5 * usual);
    assertTrue(count("fly.wing.transmission=0.95", "fly.wing.veins=0") < 100);
  }

  private static int count(String... assignments) {
    return SceneRuns.events(
            new RenderedFlyScene(
                RenderedFlySceneSettings.defaults()
                    .with(
                        "run.durationS=0.01",
                        "noise.hotPixels=0",
                        "noise.shotHz=0",
                        "noise.leakHz=0",
                        "pixel.refractoryUs=0",
                        "pixel.bandwidthHz=10000")
                    .with(assignments)))
        .size();
  }

  @Test
  void slowPixelsDelayTheWing() {
    double fast = meanLag("pixel.bandwidthHz=0");
    double slow = meanLag("pixel.bandwidthHz=2000");
    // an event comes when the edge has covered (1 - e^-0.3) / 0.3 of the pixel, beyond its middle
    assertEquals(0.36 / 32, fast, 0.01);
    assertTrue(slow > fast + 0.02, slow + " " + fast);
  }

  /** Mean lag of OFF events behind the left leading edge in mid stroke, radians. */
  private static double meanLag(String assignment) {
    RenderedFlyScene scene =
        pure(
            assignment,
            "run.durationS=0.02",
            "fly.wing.rootExponent=1",
            "fly.wing.tipExponent=0.1");
    EventPacket events = SceneRuns.events(scene);
    double sum = 0;
    int count = 0;
    for (int i = 0; i < events.size(); i++) {
      FlyTruth truth = scene.truthAt(events.timeUs(i));
      double speed = Math.cos(truth.leftPhaseRad());
      if (!events.isOn(i)
          && SceneRuns.isLeft(truth, events.x(i), events.y(i))
          && Math.abs(speed) > 0.7) {
        double angle = SceneRuns.strokeAngle(truth, true, events.x(i), events.y(i));
        sum += Math.signum(speed) * SceneRuns.turn(angle, truth.leftLeadingRad());
        count++;
      }
    }
    return sum / count;
  }

  @Test
  void lightMayHaveVignettingAndFlicker() {
    double[] image = pure("light.vignetting=0.4").imageAt(0);
    assertEquals(0.6, image[0], 1e-9);
    assertEquals(1, image[64 * 128 + 64], 1e-3);

    EventPacket events =
        SceneRuns.events(
            pure(
                "fly.wing.transmission=1",
                "light.flickerShare=0.5",
                "light.flickerHz=100",
                "run.durationS=0.01"));
    // from 1 to 1.5 to 0.5 to 1 in a period: ln 1.5 / 0.3, ln 3 / 0.3, ln 2 / 0.3
    assertEquals(0.5 * (1 + 3 + 2) * 2, events.size() / (128.0 * 128), 1.1);
  }

  @Test
  void invalidSettingsAreRejectedWithAMessage() {
    RenderedFlySceneSettings settings = RenderedFlySceneSettings.defaults();
    for (String bad :
        List.of(
            "fly.wing.transmission=0",
            "fly.wing.axisShare=0.7",
            "fly.pitch.flipShare=nan",
            "photoreceptor.followerHz=-1",
            "light.vignetting=1.5",
            "wings=4")) {
      assertThrows(SettingsProblem.class, () -> settings.with(bad), bad);
    }
  }
}
