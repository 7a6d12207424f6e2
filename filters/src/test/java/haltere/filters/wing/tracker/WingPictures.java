package haltere.filters.wing.tracker;

import haltere.core.event.EventPacket;
import haltere.core.simulation.internal.fly.FlyScene;
import haltere.core.simulation.internal.fly.FlySceneSettings;
import haltere.core.simulation.internal.fly.FlyTruth;
import haltere.core.sink.internal.SvgPlot;
import haltere.filters.wing.WingAverage;
import haltere.filters.wing.WingEstimate;
import haltere.filters.wing.WingPart;
import haltere.filters.wing.WingTrackerSettings;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Draws the pictures of docs/wings.md. */
final class WingPictures {
  private static final String MEASURED = "#888888";
  private static final String BLUE = "#1f6fb4";
  private static final String RED = "#c23b22";
  private static final String GREEN = "#2f8f4e";

  private WingPictures() {}

  private static List<WingEstimate> track(
      FlySceneSettings scene, double seconds, List<WingEstimate> averages) {
    List<WingEstimate> left = new ArrayList<>();
    EventPacket events = Flies.events(seconds, scene);
    new WingTracker(
            new FlyScene(scene).geometry(),
            WingTrackerSettings.defaults()
                .with("filter.method=BOTH", "output.rateHz=20000", Flies.LATENCY),
            result -> {
              if (result instanceof WingEstimate estimate && estimate.edge() == WingPart.LEFT) {
                left.add(estimate);
              } else if (result instanceof WingAverage average
                  && average.estimate().edge() == WingPart.LEFT) {
                averages.add(average.estimate());
              }
            })
        .track(events);
    return left;
  }

  private static double[] times(List<WingEstimate> rows, long fromUs) {
    return rows.stream().mapToDouble(e -> (e.timeUs() - fromUs) * 1e-3).toArray();
  }

  private static List<WingEstimate> between(List<WingEstimate> rows, long fromUs, long toUs) {
    return rows.stream().filter(e -> e.timeUs() >= fromUs && e.timeUs() <= toUs).toList();
  }

  /**
   * Four beats: truth, filter, running average.
   *
   * @param folder where the picture goes
   * @return largest error of the filter, degrees
   */
  static double stroke(Path folder) throws IOException {
    FlySceneSettings scene =
        FlySceneSettings.defaults().with("run.seed=2", "disturbances.manoeuvres.everyS=0");
    List<WingEstimate> averages = new ArrayList<>();
    List<WingEstimate> filtered = between(track(scene, 0.36, averages), 335_000, 355_000);
    averages = between(averages, 335_000, 355_000);
    FlyScene truth = new FlyScene(scene);
    double[] t = times(filtered, 335_000);
    double[] real = new double[t.length];
    double[] low = new double[t.length];
    double[] high = new double[t.length];
    double[] value = new double[t.length];
    double worst = 0;
    for (int i = 0; i < t.length; i++) {
      WingEstimate e = filtered.get(i);
      FlyTruth now = truth.truthAt(e.timeUs());
      real[i] = Math.toDegrees(now.leftAngleRad());
      value[i] = Math.toDegrees(e.angleRad());
      low[i] = value[i] - 2 * Math.toDegrees(e.sdAngleRad());
      high[i] = value[i] + 2 * Math.toDegrees(e.sdAngleRad());
      worst = Math.max(worst, Math.abs(value[i] - real[i]));
    }
    new SvgPlot(0, 20, 0, 180)
        .line("truth", MEASURED, t, real)
        .band("", BLUE, t, low, high)
        .line("Kalman filter, ± 2 SD", BLUE, t, value)
        .line(
            "running average",
            RED,
            times(averages, 335_000),
            averages.stream().mapToDouble(e -> Math.toDegrees(e.angleRad())).toArray())
        .write(
            folder.resolve("wings-stroke.svg"),
            "Stroke angle of the left wing",
            "time (ms)",
            "degrees");
    return worst;
  }

  /**
   * The frequency through a manoeuvre.
   *
   * @param folder where the picture goes
   * @return root of the mean squared error of the filter, hertz
   */
  static double manoeuvre(Path folder) throws IOException {
    FlySceneSettings scene =
        FlySceneSettings.defaults()
            .with(
                "run.seed=5", "disturbances.manoeuvres.everyS=1.2", "stroke.beat.frequencySdHz=1");
    List<WingEstimate> filtered = track(scene, 1.1, new ArrayList<>());
    FlyScene truth = new FlyScene(scene);
    List<WingEstimate> thinned = new ArrayList<>();
    for (int i = 0; i < filtered.size(); i += 40) {
      thinned.add(filtered.get(i));
    }
    double[] t = times(thinned, 0);
    double[] real = new double[t.length];
    double[] value = new double[t.length];
    double[] low = new double[t.length];
    double[] high = new double[t.length];
    double squares = 0;
    for (int i = 0; i < t.length; i++) {
      WingEstimate e = thinned.get(i);
      real[i] = truth.truthAt(e.timeUs()).leftFrequencyHz();
      value[i] = e.frequencyHz();
      low[i] = value[i] - 2 * e.sdFrequencyHz();
      high[i] = value[i] + 2 * e.sdFrequencyHz();
      squares += (value[i] - real[i]) * (value[i] - real[i]);
    }
    new SvgPlot(0, 1100, 190, 225)
        .band("", GREEN, t, low, high)
        .line("truth", MEASURED, t, real)
        .line("Kalman filter, ± 2 SD", GREEN, t, value)
        .write(
            folder.resolve("wings-manoeuvre.svg"),
            "Frequency of the left wing in a manoeuvre",
            "time (ms)",
            "Hz");
    return Math.sqrt(squares / t.length);
  }
}
