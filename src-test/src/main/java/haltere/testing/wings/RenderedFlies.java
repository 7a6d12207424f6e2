package haltere.testing.wings;

import haltere.core.simulation.internal.fly.RenderedFlySceneSettings;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * Random rendered flies: wing shapes, pitches, transmissions, pixel speeds and thresholds over wide
 * ranges; each seed makes another one.
 */
public final class RenderedFlies {
  private static final String[] WAVEFORMS = {"MUIJRES", "FRY", "MAEDA", "SINUSOID", "FREE"};
  private static final int[][] SENSORS = {{128, 128}, {240, 180}, {346, 260}};

  /** Contrast of a membrane over the threshold of the pixels, at the least. */
  private static final double MIN_CONTRAST = 1.2;

  /** Largest transmission of a membrane that a threshold of 0.1 sees. */
  private static final double VISIBLE_TRANSMISSION = Math.exp(-0.1 * MIN_CONTRAST) - 0.001;

  private RenderedFlies() {}

  /**
   * A fly of any kind.
   *
   * @param seed of everything about it
   * @return an endless scene
   */
  public static RenderedFlySceneSettings random(long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    int[] sensor = SENSORS[random.nextInt(SENSORS.length)];
    double length = random.nextDouble(25, sensor[1] < 150 ? 50 : 60);
    double room = Math.min(20, Math.max(1, sensor[1] / 2.0 - 1.1 * length));
    double amplitude = Math.toRadians(random.nextDouble(50, 80));
    double centre = Math.min(Math.toRadians(random.nextDouble(92, 108)), Math.PI - 0.1 - amplitude);
    double unlike = Math.toRadians(random.nextDouble(-6, 6));
    double transmission = random.nextDouble(0.3, VISIBLE_TRANSMISSION);
    // a membrane whose contrast is below the threshold has no trailing edge that a pixel could see
    double most = Math.min(0.4, -Math.log(transmission) / MIN_CONTRAST);
    double threshold = logarithmic(random, 0.1, most);
    double bandwidth = logarithmic(random, 160, 16_000);
    List<String> set =
        new ArrayList<>(
            List.of(
                "run.seed=" + seed,
                "sensor.widthPx=" + sensor[0],
                "sensor.heightPx=" + sensor[1],
                "fly.body.headingRad=" + random.nextDouble(0, 2 * Math.PI),
                "fly.body.offsetXPx=" + random.nextDouble(-room, room),
                "fly.body.offsetYPx=" + random.nextDouble(-room, room),
                "fly.body.lengthPx=" + 0.95 * length,
                "fly.body.hingeOffsetPx=" + random.nextDouble(0, 6) * Math.min(1, length / 46),
                "fly.body.wobblePx=" + random.nextDouble(0, 0.2),
                "fly.body.contrast=" + random.nextDouble(1.5, 3),
                "fly.wing.lengthPx=" + length,
                "fly.wing.chordShare=" + random.nextDouble(0.12, 0.42),
                "fly.wing.rootExponent=" + random.nextDouble(0.4, 1.4),
                "fly.wing.tipExponent=" + random.nextDouble(0.15, 0.8),
                "fly.wing.axisShare=" + random.nextDouble(0, 0.5),
                "fly.wing.transmission=" + transmission,
                "fly.wing.veins=" + random.nextInt(5),
                "fly.wing.veinTransmission=" + random.nextDouble(0.2, 0.6),
                "fly.pitch.towardsTailRad=" + random.nextDouble(0.3, 1.1),
                "fly.pitch.towardsHeadRad=" + random.nextDouble(0.3, 1.1),
                "fly.pitch.flipShare=" + random.nextDouble(0.1, 0.4),
                "fly.pitch.flipAdvanceRad=" + random.nextDouble(-0.4, 0.5),
                "stroke.beat.frequencyHz=" + random.nextDouble(150, 260),
                "stroke.beat.frequencySdHz=" + random.nextDouble(0, 5),
                "stroke.beat.waveform=" + WAVEFORMS[random.nextInt(WAVEFORMS.length)],
                "stroke.beat.harmonics.second=" + random.nextDouble(0, 0.1),
                "stroke.beat.harmonics.secondPhaseRad=" + random.nextDouble(0, 6.28),
                "stroke.left.amplitudeRad=" + (amplitude + unlike / 2),
                "stroke.right.amplitudeRad=" + (amplitude - unlike / 2),
                "stroke.left.centreRad=" + centre,
                "stroke.right.centreRad=" + centre,
                "stroke.right.phaseLagRad=" + Math.toRadians(random.nextDouble(-15, 15)),
                "light.vignetting=" + random.nextDouble(0, 0.4),
                "pixel.threshold=" + threshold,
                "pixel.thresholdSd=" + threshold * random.nextDouble(0.05, 0.2),
                "pixel.bandwidthHz=" + bandwidth,
                "pixel.refractoryUs=" + logarithmic(random, 1, 500),
                "pixel.latencyUs=" + logarithmic(random, 1, 60),
                "pixel.jitterUs=" + random.nextDouble(0, 15),
                "photoreceptor.followsLight=" + random.nextBoolean(),
                "noise.shotHz=" + 5 * Math.pow(random.nextDouble(), 2),
                "noise.hotPixels=" + random.nextInt(13)));
    if (random.nextBoolean()) {
      set.add("photoreceptor.followerHz=" + bandwidth * random.nextDouble(1, 5));
    }
    set.add("fly.manoeuvres.everyS=" + (random.nextInt(4) == 0 ? 1.3 : 0));
    return RenderedFlySceneSettings.defaults().with(set.toArray(new String[0]));
  }

  private static double logarithmic(SplittableRandom random, double min, double max) {
    return Math.exp(random.nextDouble(Math.log(min), Math.log(max)));
  }

  /** Events of the wings an edge and beat, from all events of a run less what noise makes. */
  static double eventsPerEdgeAndBeat(RenderedFlySceneSettings scene, long events, double seconds) {
    return RandomFlies.eventsPerEdgeAndBeat(
        scene.sensor(), scene.noise(), scene.stroke().beat().frequencyHz(), events, seconds);
  }
}
