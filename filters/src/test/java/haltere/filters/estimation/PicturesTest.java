package haltere.filters.estimation;

import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.sink.internal.SvgPlot;
import haltere.filters.estimation.FilterStep.Correction;
import haltere.filters.estimation.motion.AxisMotion;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.junit.jupiter.api.Test;

/**
 * Draws the pictures of docs/estimation.md that belong to no example into build/pictures; {@code
 * ./gradlew :filters:refreshPictures} takes them over. Each test also says what its picture shows.
 */
class PicturesTest {
  private static final Path FOLDER = Path.of("build", "pictures");
  private static final String MEASURED = "#888888";
  private static final String BLUE = "#1f6fb4";
  private static final String RED = "#c23b22";

  private static void write(SvgPlot plot, String name, String title, String x, String y)
      throws IOException {
    Path file = FOLDER.resolve("estimation-" + name + ".svg");
    plot.write(file, title, x, y);
    assertTrue(Files.size(file) < 40_000, "small enough to commit: " + Files.size(file));
  }

  @Test
  void meanSquaredInnovationRevealsOverconfidence() throws IOException {
    int window = 50;
    SvgPlot plot = new SvgPlot(0, 50, 0, 5.5);
    Interval band = Consistency.meanBand(1, window, 0.95);
    double[] ends = {0, 50};
    plot.band(
        "95 % band",
        MEASURED,
        ends,
        new double[] {band.lower(), band.lower()},
        new double[] {band.upper(), band.upper()});
    double[] consistent = windowedNis(0.3, window);
    double[] trusting = windowedNis(0.1, window);
    double[] t = new double[consistent.length];
    for (int i = 0; i < t.length; i++) {
      t[i] = (i + 1) * window * 0.02;
    }
    plot.line("R as it is", BLUE, t, consistent);
    plot.line("R three times too small", RED, t, trusting);
    write(plot, "nis", "Mean NIS of 50 innovations", "time (s)", "mean of y² / S");
    int inside = 0;
    for (double value : consistent) {
      inside += band.contains(value) ? 1 : 0;
    }
    assertTrue(inside >= consistent.length * 0.85, "the consistent one stays inside");
    for (double value : trusting) {
      assertTrue(value > band.upper(), "the other does not");
    }
  }

  private static double[] windowedNis(double believed, int window) {
    Draws draws = new Draws(12);
    KalmanFilter filter =
        new KalmanFilter(
            AxisMotion.constantVelocity(1, 1), Matrices.column(0, 0), Matrices.diagonal(1, 1));
    LinearMeasurement position = LinearMeasurement.ofEntries(2, believed, 0);
    DMatrixRMaj truth = draws.normal(Matrices.diagonal(1, 1));
    AxisMotion model = AxisMotion.constantVelocity(1, 1);
    DMatrixRMaj q = new DMatrixRMaj(2, 2);
    model.noise(truth, 0.02, q);
    double[] nis = new double[1];
    filter.observe(step -> nis[0] = step instanceof Correction c ? c.nis() : nis[0]);
    double[] means = new double[50];
    for (int k = 0; k < means.length * window; k++) {
      DMatrixRMaj next = new DMatrixRMaj(2, 1);
      model.evolve(truth, 0.02, next);
      CommonOps_DDRM.add(next, draws.normal(q), truth);
      filter.predict(0.02);
      filter.update(position, truth.get(0) + draws.normal(Math.sqrt(0.3)));
      means[k / window] += nis[0] / window;
    }
    return means;
  }
}
