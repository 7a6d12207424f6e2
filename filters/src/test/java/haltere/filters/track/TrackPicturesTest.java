package haltere.filters.track;

import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import haltere.core.sink.internal.SvgPlot;
import haltere.testing.EventPackets;
import haltere.testing.EventPackets.BlobPath;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;

/**
 * Draws the pictures of docs/kalman-tracks.md into build/pictures; {@code ./gradlew
 * :filters:refreshPictures} takes them over. They are figures 2 and 3 of Cardinale (2006) for a
 * simulated blob on a circle. Each test also says what its picture shows.
 */
class TrackPicturesTest {
  private static final Path FOLDER = Path.of("build", "pictures");
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);
  private static final double SHOWN_S = 1;
  private static final String GREY = "#888888";
  private static final String BLUE = "#1f6fb4";
  private static final String RED = "#c23b22";
  private static final String GREEN = "#2f8f4e";

  private static List<TrackUpdate> updates(KalmanTracksSettings settings) {
    KalmanTracks tracks = new KalmanTracks(SENSOR, settings, timeUs -> {});
    List<TrackUpdate> all = new ArrayList<>();
    tracks.observe(() -> true, all::add);
    BlobPath circle = new BlobPath(64, 64, 40, 2_000_000, 4);
    tracks.track(EventPackets.blob(SENSOR, 12, (long) (SHOWN_S * 1e6), circle, 6000, 0));
    return all;
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
  void estimateIsSmootherThanTheClusterPosition() throws IOException {
    List<TrackUpdate> updates = updates(KalmanTracksSettings.defaults());
    double[] t = times(updates);
    double[] measured = each(updates, TrackUpdate::measuredX);
    double[] estimated = each(updates, TrackUpdate::x);
    SvgPlot plot =
        new SvgPlot(0, SHOWN_S, 0, 127)
            .dots("location of the cluster", GREY, t, measured)
            .line("estimate", BLUE, t, estimated);
    write(plot, "position", "A blob on a circle: measured and estimated column", "x (px)");
    assertTrue(roughness(estimated) < 0.8 * roughness(measured));
  }

  @Test
  void covarianceSettlesWithin100Ms() throws IOException {
    List<TrackUpdate> updates = updates(KalmanTracksSettings.defaults());
    double[] t = times(updates);
    double[] velocity = each(updates, update -> Math.log10(update.pVxvx()));
    SvgPlot plot =
        new SvgPlot(0, SHOWN_S, -2, 6)
            .line("position, px²", BLUE, t, each(updates, u -> Math.log10(u.pXx())))
            .line("both, px²/s", GREEN, t, each(updates, u -> Math.log10(Math.abs(u.pXvx()))))
            .line("velocity, px²/s²", RED, t, velocity);
    write(plot, "covariance", "Entries of P of one axis", "decadic logarithm");
    int settled = 0;
    while (t[settled] < t[0] + 0.1) {
      settled++;
    }
    double end = velocity[velocity.length - 1];
    assertTrue(velocity[0] > end + 0.8 && velocity[settled] < end + 0.2);
  }

  @Test
  void gainFallsWithTheAgeOfATrackUnderDynamicVariances() throws IOException {
    List<TrackUpdate> updates = updates(dynamic());
    double[] gain = each(updates, TrackUpdate::gainX);
    SvgPlot plot = new SvgPlot(0, SHOWN_S, 0, 1).line("position", BLUE, times(updates), gain);
    write(plot, "gain", "Dynamic variances: gain K", "1");
    assertTrue(gain[2] > 1.5 * gain[gain.length - 1]);
  }

  @Test
  void dynamicVariancesApproachTheirFinalValues() throws IOException {
    List<TrackUpdate> updates = updates(dynamic());
    double[] t = times(updates);
    double[] measurement = each(updates, TrackUpdate::rPx2);
    double[] process = each(updates, TrackUpdate::qXx);
    SvgPlot plot =
        new SvgPlot(0, SHOWN_S, 0, 10)
            .line("measurement variance, px²", BLUE, t, measurement)
            .line("process variance, px²", RED, t, process);
    write(plot, "variances", "Dynamic variances with the age of a track", "variance");
    int end = updates.size() - 1;
    assertTrue(measurement[0] < 2 && measurement[end] > 7.5);
    assertTrue(process[0] > 9 && process[end] < 1.5);
  }

  private static KalmanTracksSettings dynamic() {
    return KalmanTracksSettings.original()
        .with(
            "clusters.motion.mixingFactor=0.05",
            "filter.varianceMixingFactor=0.05",
            "life.eventsTillTrack=60");
  }
}
