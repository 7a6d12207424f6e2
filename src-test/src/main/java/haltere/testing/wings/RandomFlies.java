package haltere.testing.wings;

import haltere.core.simulation.internal.fly.FlySceneSettings;
import haltere.core.simulation.internal.sensor.NoiseSettings;
import haltere.core.simulation.internal.sensor.SensorSettings;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/** Random flies over the ranges in which the tracker is to work; each seed makes another one. */
public final class RandomFlies {
  private static final String[] WAVEFORMS = {"MUIJRES", "FRY", "MAEDA", "CHEN_SUN", "FREE"};

  private RandomFlies() {}

  /**
   * A fly of any kind.
   *
   * @param seed of everything about it
   * @return an endless scene
   */
  public static FlySceneSettings random(long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    double length = random.nextDouble(20, 55);
    double room = Math.max(1, 62 - 0.9 * length);
    double amplitude = Math.toRadians(random.nextDouble(30, 80));
    // asymmetric by 5 degrees and more, and not beyond the tail
    double centre =
        Math.min(Math.toRadians(random.nextDouble(95, 108)), Math.PI - 0.05 - amplitude);
    double unlike = Math.toRadians(random.nextDouble(-6, 6));
    double unlikeCentre = Math.toRadians(random.nextDouble(-2, 2));
    double bandwidth =
        random.nextInt(6) == 0 ? 0 : Math.exp(random.nextDouble(Math.log(300), Math.log(10_000)));
    List<String> set =
        new ArrayList<>(
            List.of(
                "run.seed=" + seed,
                "fly.body.headingRad=" + random.nextDouble(0, 2 * Math.PI),
                "fly.body.offsetXPx=" + random.nextDouble(-room, room),
                "fly.body.offsetYPx=" + random.nextDouble(-room, room),
                "fly.body.lengthPx=" + 0.95 * length,
                "fly.body.hingeOffsetPx=" + random.nextDouble(0, 6) * Math.min(1, length / 46),
                "fly.body.wobblePx=" + random.nextDouble(0, 0.4),
                "fly.wing.lengthPx=" + length,
                "fly.wing.contrast=" + random.nextDouble(0.5, 1.2),
                "fly.wing.visibleShare="
                    + Math.exp(random.nextDouble(Math.log(0.06), Math.log(0.7))),
                "stroke.beat.frequencyHz=" + random.nextDouble(80, 350),
                "stroke.beat.waveform=" + WAVEFORMS[random.nextInt(WAVEFORMS.length)],
                "stroke.beat.harmonics.second=" + random.nextDouble(0, 0.15),
                "stroke.beat.harmonics.secondPhaseRad=" + random.nextDouble(0, 6.28),
                "stroke.left.amplitudeRad=" + (amplitude + unlike / 2),
                "stroke.right.amplitudeRad=" + (amplitude - unlike / 2),
                "stroke.left.centreRad=" + (centre + unlikeCentre / 2),
                "stroke.right.centreRad=" + (centre - unlikeCentre / 2),
                "stroke.right.phaseLagRad=" + Math.toRadians(random.nextDouble(-15, 15)),
                "pixel.bandwidthHz=" + bandwidth,
                "noise.shotHz=" + 10 * Math.pow(random.nextDouble(), 2),
                "noise.hotPixels=" + random.nextInt(13)));
    if (random.nextInt(4) == 0) {
      set.add("disturbances.wire.widthPx=3");
      set.add("disturbances.wire.angleRad=" + random.nextDouble(0, 3.14));
      set.add("disturbances.wire.offsetPx=" + random.nextDouble(-30, 30));
    }
    set.add("disturbances.manoeuvres.everyS=" + (random.nextInt(3) == 0 ? 1.3 : 0));
    return FlySceneSettings.defaults().with(set.toArray(new String[0]));
  }

  /**
   * A steady fly of 200 Hz in heavy noise: 3 Hz a pixel, 12 hot pixels, a wire, and about 60 events
   * an edge and beat.
   *
   * @param seed of everything about it
   * @return an endless scene
   */
  public static FlySceneSettings heavyNoise(long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    return FlySceneSettings.defaults()
        .with(
            "run.seed=" + seed,
            "fly.body.headingRad=" + random.nextDouble(0, 2 * Math.PI),
            "fly.wing.visibleShare=0.024",
            "noise.shotHz=3",
            "noise.hotPixels=12",
            "disturbances.wire.widthPx=3",
            "disturbances.wire.angleRad=" + random.nextDouble(0, 3.14),
            "disturbances.manoeuvres.everyS=0");
  }

  /** Events of the wings an edge and beat, from all events of a run less what noise makes. */
  static double eventsPerEdgeAndBeat(FlySceneSettings scene, long events, double seconds) {
    return eventsPerEdgeAndBeat(
        scene.sensor(), scene.noise(), scene.stroke().beat().frequencyHz(), events, seconds);
  }

  static double eventsPerEdgeAndBeat(
      SensorSettings sensor, NoiseSettings noise, double beatHz, long events, double seconds) {
    double pixels = (double) sensor.widthPx() * sensor.heightPx();
    double noiseHz =
        pixels * (noise.shotHz() + noise.leakHz()) + noise.hotPixels() * noise.hotRateHz();
    return (events / seconds - noiseHz) / 4 / beatHz;
  }
}
