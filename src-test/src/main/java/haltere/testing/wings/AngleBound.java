package haltere.testing.wings;

import haltere.core.event.EventPacket;
import haltere.core.simulation.internal.fly.FlyTruth;
import haltere.core.simulation.internal.fly.RenderedFlyScene;
import haltere.core.simulation.internal.fly.RenderedFlySceneSettings;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.filters.estimation.Angles;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * Cramér-Rao bound of a wing's angle on rendered flies: {@code ./gradlew
 * :src-test:boundRenderedWings -Pseeds='1 4 7'}.
 *
 * <p>Times of events have a jitter and thresholds a spread; how times change with each number of
 * the scene comes from the scene itself by finite differences. Their Fisher information, with what
 * {@link RenderedFlies} draws from as prior (Van Trees, 1968, Detection, Estimation and Modulation
 * Theory I, sec. 2.4.3), is inverted and carried over to the angle of the left wing. The form of
 * the model is known to the bound, the noise events are left out: no estimator is better, and one
 * that does not know the form is worse.
 */
public final class AngleBound {
  private static final double SECONDS = 0.05;
  private static final double SETTLED_US = 15_000;
  private static final double MATCH_US = 250;
  private static final double RUN_US = 2500;
  private static final int HARMONICS = 4;
  private static final double HARMONIC_SD_RAD = 0.1;

  /** Variance of a time that is a whole number of microseconds. */
  private static final double ROUNDING_US2 = 1.0 / 12;

  /** A number of the scene, its standard deviation before any event, and the step by it. */
  private record Unknown(String name, double sd, double step, boolean isPixel) {}

  /** Times of the events that begin a run, by pixel and polarity. */
  private final Map<Integer, long[]> base;

  private final RenderedFlySceneSettings settings;
  private final List<double[]> timesBy = new ArrayList<>();
  private final List<double[]> anglesBy = new ArrayList<>();
  private final List<Double> scaleBy = new ArrayList<>();
  private final List<Boolean> pixels = new ArrayList<>();
  private final double jitterUs;
  private final double spread;
  private final int size;
  private double[] byThreshold;

  private AngleBound(RenderedFlySceneSettings scene) {
    jitterUs = Math.sqrt(Math.pow(scene.pixel().jitterUs(), 2) + ROUNDING_US2);
    spread = scene.pixel().thresholdSd() / scene.pixel().threshold();
    settings =
        scene.with(
            "pixel.jitterUs=0", "noise.shotHz=0", "noise.hotPixels=0", "fly.body.wobblePx=0");
    base = events(settings);
    size = base.values().stream().mapToInt(times -> times.length).sum();
  }

  /**
   * Runs.
   *
   * @param args seeds
   */
  public static void main(String[] args) {
    line(
        "seed  bandwidth  jitter  events   angle (deg), unknown: phase, all but the pixels,"
            + " those of the pixels too; phase then (us)");
    for (String seed : args) {
      RenderedFlySceneSettings scene = RenderedFlies.random(Long.parseLong(seed));
      AngleBound bound = new AngleBound(scene);
      bound.differentiate();
      line(
          "%4s %10.0f %7.1f %7d %28.2f %8.2f %8.2f %8.1f",
          seed,
          scene.pixel().bandwidthHz(),
          scene.pixel().jitterUs(),
          bound.count(),
          bound.angleDeg(2, false),
          bound.angleDeg(1000, false),
          bound.angleDeg(1000, true),
          bound.phaseUs);
    }
  }

  private static void line(String format, Object... values) {
    System.out.println(String.format(Locale.ROOT, format, values));
  }

  private List<Unknown> unknowns() {
    List<Unknown> all = new ArrayList<>();
    double omega = 2 * Math.PI * settings.stroke().beat().frequencyHz();
    for (String side : new String[] {"left", "right"}) {
      all.add(new Unknown("stroke." + side + ".phaseLagRad", 2, omega * 30e-6, false));
    }
    for (String side : new String[] {"left", "right"}) {
      all.add(new Unknown("stroke." + side + ".centreRad", 0.1, 0.01, false));
      all.add(new Unknown("stroke." + side + ".amplitudeRad", 0.15, 0.01, false));
    }
    all.add(new Unknown("stroke.beat.frequencyHz", 30, 0.2, false));
    all.add(new Unknown("stroke.beat.harmonics.second", 0.03, 0.005, false));
    all.add(new Unknown("stroke.beat.harmonics.secondPhaseRad", 1.8, 0.1, false));
    all.add(new Unknown("fly.body.headingRad", 1.8, 0.01, false));
    all.add(new Unknown("fly.body.offsetXPx", 10, 0.2, false));
    all.add(new Unknown("fly.body.offsetYPx", 10, 0.2, false));
    all.add(new Unknown("fly.body.hingeOffsetPx", 1.7, 0.2, false));
    all.add(new Unknown("fly.wing.lengthPx", 10, 0.3, false));
    all.add(new Unknown("fly.wing.chordShare", 0.09, 0.005, false));
    all.add(new Unknown("fly.wing.rootExponent", 0.29, 0.05, false));
    all.add(new Unknown("fly.wing.tipExponent", 0.19, 0.03, false));
    all.add(new Unknown("fly.wing.axisShare", 0.14, 0.02, false));
    all.add(new Unknown("fly.wing.veinTransmission", 0.12, 0.02, false));
    all.add(new Unknown("fly.pitch.towardsTailRad", 0.23, 0.03, false));
    all.add(new Unknown("fly.pitch.towardsHeadRad", 0.23, 0.03, false));
    all.add(new Unknown("fly.pitch.flipShare", 0.09, 0.02, false));
    all.add(new Unknown("fly.pitch.flipAdvanceRad", 0.26, 0.03, false));
    all.add(new Unknown("fly.wing.transmission", 0.17, 0.01, true));
    double threshold = settings.pixel().threshold();
    all.add(new Unknown("pixel.threshold", 0.4 * threshold, 0.05 * threshold, true));
    double bandwidth = settings.pixel().bandwidthHz();
    all.add(new Unknown("pixel.bandwidthHz", 1.3 * bandwidth, 0.1 * bandwidth, true));
    double follower = settings.photoreceptor().followerHz();
    if (follower > 0) {
      all.add(new Unknown("photoreceptor.followerHz", 1.4 * follower, 0.1 * follower, true));
    }
    return all;
  }

  /** Derivatives of times (us) and angles (rad) by each unknown in its standard deviation. */
  private void differentiate() {
    for (Unknown unknown : unknowns()) {
      double value = ((Number) value(unknown.name)).doubleValue();
      double scale = unknown.sd / unknown.step;
      RenderedFlySceneSettings changed;
      try {
        changed = settings.with(unknown.name + "=" + (value + unknown.step));
      } catch (IllegalArgumentException atTheLimit) {
        changed = settings.with(unknown.name + "=" + (value - unknown.step));
        scale = -scale;
      }
      double[] times = times(changed, scale);
      double[] before = angles(settings);
      double[] after = angles(changed);
      double[] angles = new double[before.length];
      for (int i = 0; i < angles.length; i++) {
        angles[i] = scale * Angles.wrapPi(after[i] - before[i]);
      }
      add(times, angles, scale, unknown.isPixel);
      if (unknown.name.equals("pixel.threshold")) {
        byThreshold = times;
      }
    }
    addHarmonics();
  }

  private void add(double[] times, double[] angles, double scale, boolean isPixel) {
    scaleBy.add(scale);
    timesBy.add(times);
    anglesBy.add(angles);
    pixels.add(isPixel);
  }

  /**
   * Any stroke of four harmonics: an angle later on is a centre that is another one for a while.
   */
  private void addHarmonics() {
    RenderedFlyScene scene = new RenderedFlyScene(settings);
    for (int side = 0; side < 2; side++) {
      double[] byCentre = timesBy.get(2 + 2 * side);
      double perRad = HARMONIC_SD_RAD / 0.1;
      for (int k = 2; k <= HARMONICS; k++) {
        for (int quarter = 0; quarter < 2; quarter++) {
          double[] times = new double[size];
          int i = 0;
          for (long[] all : base.values()) {
            for (long time : all) {
              times[i] = perRad * byCentre[i] * wave(scene, time, side, k, quarter);
              i++;
            }
          }
          double[] angles = angles(settings);
          for (int tick = 0; tick < angles.length; tick++) {
            long time = tickUs(scene, tick);
            angles[tick] = side == 0 ? HARMONIC_SD_RAD * wave(scene, time, 0, k, quarter) : 0;
          }
          add(times, angles, 0, false);
        }
      }
    }
  }

  private static double wave(RenderedFlyScene scene, long time, int side, int k, int quarter) {
    FlyTruth truth = scene.truthRows(time).get(0);
    double phase = side == 0 ? truth.leftPhaseRad() : truth.rightPhaseRad();
    return Math.sin(k * phase + quarter * Math.PI / 2);
  }

  private static long tickUs(RenderedFlyScene scene, int tick) {
    return scene.startUs() + 25_000 + 250L * tick;
  }

  private Object value(String name) {
    Object value = settings;
    for (String part : name.split("\\.")) {
      try {
        value = value.getClass().getMethod(part).invoke(value);
      } catch (ReflectiveOperationException e) {
        throw new IllegalStateException(name, e);
      }
    }
    return value;
  }

  private static double[] angles(RenderedFlySceneSettings settings) {
    RenderedFlyScene scene = new RenderedFlyScene(settings);
    double[] angles = new double[100];
    for (int tick = 0; tick < angles.length; tick++) {
      angles[tick] = scene.truthRows(tickUs(scene, tick)).get(0).leftAngleRad();
    }
    return angles;
  }

  private double[] times(RenderedFlySceneSettings changed, double scale) {
    Map<Integer, long[]> after = events(changed);
    double[] by = new double[size];
    int i = 0;
    for (Map.Entry<Integer, long[]> all : base.entrySet()) {
      long[] found = after.getOrDefault(all.getKey(), new long[0]);
      for (long time : all.getValue()) {
        by[i++] = scale * (nearest(found, time) - time);
      }
    }
    return by;
  }

  private static double nearest(long[] times, long time) {
    double best = Double.NaN;
    for (long each : times) {
      double off = Math.abs(each - time);
      if (off < MATCH_US && !(off >= Math.abs(best - time))) {
        best = each;
      }
    }
    return best;
  }

  private static Map<Integer, long[]> events(RenderedFlySceneSettings settings) {
    RenderedFlyScene scene = new RenderedFlyScene(settings);
    int width = settings.sensor().widthPx();
    boolean[] isOn = new boolean[width * settings.sensor().heightPx()];
    long[] lastUs = new long[isOn.length];
    Map<Integer, List<Long>> lists = new TreeMap<>();
    boolean[] ended = {false};
    double endUs = scene.startUs() + SECONDS * 1e6;
    StreamHandler handler =
        new StreamHandler() {
          @Override
          public void packet(EventPacket packet) {
            for (int i = 0; i < packet.size(); i++) {
              int pixel = packet.y(i) * width + packet.x(i);
              long time = packet.timeUs(i);
              boolean begins = isOn[pixel] != packet.isOn(i) || time - lastUs[pixel] > RUN_US;
              lastUs[pixel] = time;
              isOn[pixel] = packet.isOn(i);
              ended[0] |= time >= endUs;
              if (begins && time >= scene.startUs() + SETTLED_US && time < endUs) {
                lists
                    .computeIfAbsent(2 * pixel + (packet.isOn(i) ? 1 : 0), k -> new ArrayList<>())
                    .add(time);
              }
            }
          }

          @Override
          public void notified(StreamNotification notification) {
            // nothing to do
          }
        };
    while (!ended[0] && scene.next(handler)) {
      // continues until the end
    }
    Map<Integer, long[]> times = new TreeMap<>();
    lists.forEach(
        (key, list) -> times.put(key, list.stream().mapToLong(Long::longValue).toArray()));
    return times;
  }

  private boolean isUsed(int event) {
    for (double[] by : timesBy) {
      if (Double.isNaN(by[event])) {
        return false;
      }
    }
    return true;
  }

  private int count() {
    int count = 0;
    for (int i = 0; i < size; i++) {
      count += isUsed(i) ? 1 : 0;
    }
    return count;
  }

  private double phaseUs;

  /**
   * Bound of the RMS error of the left wing's angle.
   *
   * @param first so many unknowns, the others known
   * @param withPixels whether pixels and transmission are unknown as well
   * @return degrees
   */
  private double angleDeg(int first, boolean withPixels) {
    List<double[]> times = new ArrayList<>();
    List<double[]> angles = new ArrayList<>();
    double[] scales = new double[timesBy.size()];
    for (int k = 0; k < Math.min(first, timesBy.size()); k++) {
      if (withPixels || !pixels.get(k)) {
        times.add(timesBy.get(k));
        angles.add(anglesBy.get(k));
        scales[times.size() - 1] = scaleBy.get(k);
      }
    }
    int n = times.size();
    DMatrixRMaj covariance = information(times, scales, n);
    CommonOps_DDRM.invert(covariance);
    double sum = 0;
    int ticks = angles.get(0).length;
    for (int tick = 0; tick < ticks; tick++) {
      for (int k = 0; k < n; k++) {
        for (int l = 0; l < n; l++) {
          sum += angles.get(k)[tick] * covariance.get(k, l) * angles.get(l)[tick];
        }
      }
    }
    double omega = 2 * Math.PI * settings.stroke().beat().frequencyHz();
    phaseUs = 1e6 * 2 * Math.sqrt(covariance.get(0, 0)) / omega;
    return Math.toDegrees(Math.sqrt(sum / ticks));
  }

  /**
   * Fisher's information, thresholds of pixels integrated out, with the prior; less what rounded
   * times add to squares of differences.
   */
  private DMatrixRMaj information(List<double[]> times, double[] scales, int n) {
    DMatrixRMaj all = CommonOps_DDRM.identity(n);
    double weight = 1 / (jitterUs * jitterUs);
    int i = 0;
    for (long[] pixel : base.values()) {
      double[] with = new double[n];
      double square = 0;
      for (int event = 0; event < pixel.length; event++, i++) {
        if (isUsed(i)) {
          // the prior of the threshold is 0.4 of it
          double bySpread = byThreshold[i] / 0.4 * spread;
          square += weight * bySpread * bySpread;
          for (int k = 0; k < n; k++) {
            with[k] += weight * bySpread * times.get(k)[i];
            for (int l = 0; l < n; l++) {
              double rounding = scales[k] * scales[l] * ROUNDING_US2 * (k == l ? 2 : 1);
              all.add(k, l, weight * (times.get(k)[i] * times.get(l)[i] - rounding));
            }
          }
        }
      }
      for (int k = 0; k < n; k++) {
        for (int l = 0; l < n; l++) {
          all.add(k, l, -with[k] * with[l] / (1 + square));
        }
      }
    }
    return all;
  }
}
