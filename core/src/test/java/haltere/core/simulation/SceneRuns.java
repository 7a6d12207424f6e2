package haltere.core.simulation;

import haltere.core.event.EventPacket;
import haltere.core.simulation.internal.fly.FlyScene;
import haltere.core.simulation.internal.fly.FlySceneSettings;
import haltere.core.simulation.internal.fly.FlyTruth;
import haltere.core.stream.StreamGrammar;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.function.IntPredicate;

/** Helpers of scene tests: settings for ideal geometry, and reading a scene to its end. */
public final class SceneRuns {
  /** No noise, no motion of the body, no manoeuvre, a pixel without delay or mismatch. */
  private static final String[] PURE = {
    "pixel.bandwidthHz=0",
    "pixel.latencyUs=0",
    "pixel.jitterUs=0",
    "pixel.refractoryUs=0",
    "pixel.threshold=0.2",
    "pixel.thresholdSd=0",
    "noise.leakHz=0",
    "noise.shotHz=0",
    "noise.hotPixels=0",
    "fly.wing.contrast=0.3",
    "fly.wing.contrastSpread=0",
    "fly.wing.visibleShare=1",
    "fly.body.contrast=0",
    "fly.body.wobblePx=0",
    "fly.body.driftPx=0",
    "disturbances.manoeuvres.everyS=0"
  };

  private SceneRuns() {}

  public static FlySceneSettings pure(String... assignments) {
    return FlySceneSettings.defaults().with(PURE).with(assignments);
  }

  public static FlySceneSettings fly(String... assignments) {
    return FlySceneSettings.defaults().with(assignments);
  }

  /** Noise alone: the wings are clear as glass and the body as bright as the background. */
  public static FlySceneSettings empty(String... assignments) {
    return pure("fly.wing.visibleShare=0").with(assignments);
  }

  public static StreamRecorder record(Scene<?> scene) {
    StreamRecorder recorder = new StreamRecorder();
    try {
      scene.drainTo(new StreamGrammar(recorder));
    } catch (IOException impossible) {
      throw new UncheckedIOException(impossible);
    }
    return recorder;
  }

  public static EventPacket events(Scene<?> scene) {
    return record(scene).events();
  }

  public static EventPacket events(FlySceneSettings settings, double seconds) {
    return events(new FlyScene(settings.with("run.durationS=" + seconds)));
  }

  public static int count(EventPacket events, IntPredicate wanted) {
    int count = 0;
    for (int i = 0; i < events.size(); i++) {
      count += wanted.test(i) ? 1 : 0;
    }
    return count;
  }

  /** Difference of two angles in (-pi, pi]. */
  public static double turn(double from, double to) {
    return Math.IEEEremainder(to - from, 2 * Math.PI);
  }

  /** Whether an event lies to the left of the body axis. */
  public static boolean isLeft(FlyTruth truth, double x, double y) {
    double dx = x - truth.centreXPx();
    double dy = y - truth.centreYPx();
    return dy * Math.cos(truth.headingRad()) - dx * Math.sin(truth.headingRad()) > 0;
  }

  /** Stroke angle of a place about the hinge of its side, in [0, 2 pi). */
  public static double strokeAngle(FlyTruth truth, boolean left, double x, double y) {
    double direction =
        left
            ? Math.atan2(y - truth.leftHingeYPx(), x - truth.leftHingeXPx())
            : Math.atan2(y - truth.rightHingeYPx(), x - truth.rightHingeXPx());
    double angle = left ? direction - truth.headingRad() : truth.headingRad() - direction;
    return angle - 2 * Math.PI * Math.floor(angle / (2 * Math.PI));
  }
}
