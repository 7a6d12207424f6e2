package haltere.filters.track.kalman;

import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import haltere.core.sink.SvgPlot;
import haltere.filters.track.KalmanTracksSettings;
import haltere.filters.track.TrackUpdate;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;

/**
 * Draws the pictures of docs/tracking.md into build/pictures; {@code ./gradlew
 * :filters:refreshPictures} takes them over. They are the source's figures 2 and 3, on the
 * simulated dots. Each test also says what its picture shows.
 */
class TrackPicturesTest {
  private static final Path FOLDER = Path.of("build", "pictures");
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);
  private static final double SHOWN_S = 1;
  private static final String GREY = "#888888";
  private static final String BLUE = "#1f6fb4";
  private static final String RED = "#c23b22";
  private static final String GREEN = "#2f8f4e";

  /** What the first track of a scene of three dots on circles has done. */
  private static List<TrackUpdate> updates(KalmanTracksSettings settings) {
    KalmanTracksFilter filter = new KalmanTracksFilter(SENSOR, settings);
    List<TrackUpdate> all = new ArrayList<>();
    filter.updates().subscribe(all::add);
    filter.process(KalmanTracksFilterTest.dots(SENSOR, 3, 1_000_000));
    int id = all.get(0).id();
    return all.stream().filter(u -> u.id() == id && u.timeUs() < SHOWN_S * 1e6).toList();
  }

  private static double[] each(List<TrackUpdate> updates, ToDoubleFunction<TrackUpdate> value) {
    return updates.stream().mapToDouble(value).toArray();
  }

  private static double[] times(List<TrackUpdate> updates) {
    return each(updates, update -> update.timeUs() * 1e-6);
  }

  private static void write(SvgPlot plot, String name, String title, String y) throws IOException {
    Path file = FOLDER.resolve("tracking-" + name + ".svg");
    plot.write(file, title, "time (s)", y);
    assertTrue(Files.size(file) < 40_000, "small enough to commit: " + Files.size(file));
  }

  private static double roughness(double[] x) {
    double sum = 0;
    for (int i = 2; i < x.length; i++) {
      sum += Math.abs(x[i] - 2 * x[i - 1] + x[i - 2]);
    }
    return sum / (x.length - 2);
  }

  @Test
  void theEstimateIsSmootherThanTheMeanOfEvents() throws IOException {
    List<TrackUpdate> updates = updates(KalmanTracksSettings.defaults());
    double[] t = times(updates);
    double[] measured = each(updates, TrackUpdate::measuredX);
    double[] estimated = each(updates, TrackUpdate::x);
    SvgPlot plot =
        new SvgPlot(0, SHOWN_S, 0, 127)
            .dots("mean of the events of 10 ms", GREY, t, measured)
            .line("estimate", BLUE, t, estimated);
    write(plot, "position", "A dot on a circle: what is measured and what is estimated", "x (px)");
    assertTrue(roughness(estimated) < 0.7 * roughness(measured));
  }

  @Test
  void theCovarianceSettlesWithinATenthOfASecond() throws IOException {
    List<TrackUpdate> updates =
        updates(
            KalmanTracksSettings.defaults()
                .with("motion.model=straight", "motion.minProcessVariance=20000"));
    double[] t = times(updates);
    double[] place = each(updates, u -> Math.log10(u.pXx()));
    double[] cross = each(updates, u -> Math.log10(Math.abs(u.pXvx())));
    double[] velocity = each(updates, u -> Math.log10(u.pVxvx()));
    SvgPlot plot =
        new SvgPlot(0, SHOWN_S, -2, 6)
            .line("place, px²", BLUE, t, place)
            .line("place and velocity, px²/s", GREEN, t, cross)
            .line("velocity, px²/s²", RED, t, velocity);
    write(plot, "covariance", "Entries of P of one axis", "decadic logarithm");
    int settled = 0;
    while (t[settled] < t[0] + 0.1) {
      settled++;
    }
    double least = velocity[velocity.length - 1];
    assertTrue(velocity[0] > least + 1 && velocity[settled] < least + 0.5);
  }

  @Test
  void withDynamicVariancesTheGainFallsAsTheTrackGrowsOld() throws IOException {
    List<TrackUpdate> updates =
        updates(KalmanTracksSettings.original().with("measurement.eventsTillTrack=60"));
    double[] t = times(updates);
    double[] gain = each(updates, TrackUpdate::gainX);
    SvgPlot plot = new SvgPlot(0, SHOWN_S, 0, 1).line("K of the place", BLUE, t, gain);
    write(plot, "gain", "The original's settings: how much of an innovation is believed", "1");
    assertTrue(gain[2] > 1.5 * gain[gain.length - 1]);
  }
}
