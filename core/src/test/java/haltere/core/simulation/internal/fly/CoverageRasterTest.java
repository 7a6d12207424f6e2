package haltere.core.simulation.internal.fly;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.core.simulation.internal.sensor.SeededRandom;
import org.junit.jupiter.api.Test;

/** The share of each pixel that a polygon covers. */
class CoverageRasterTest {
  private static final int WIDTH = 24;
  private static final int HEIGHT = 20;

  private static double[] cover(CoverageRaster raster) {
    double[] cover = new double[WIDTH * HEIGHT];
    raster.finish();
    for (int y = raster.fromRow(); y < raster.toRow(); y++) {
      for (int x = raster.from(y); x < raster.to(y); x++) {
        cover[y * WIDTH + x] = raster.at(x, y);
      }
    }
    return cover;
  }

  @Test
  void rectangleCoversSharesOfPixels() {
    CoverageRaster raster = new CoverageRaster(WIDTH, HEIGHT);
    raster.add(new double[] {3, 5.25, 5.25, 3}, new double[] {4, 4, 6.5, 6.5}, 4);
    double[] cover = cover(raster);

    assertEquals(0.25, cover[4 * WIDTH + 3], 1e-12);
    assertEquals(0.5, cover[4 * WIDTH + 4], 1e-12);
    assertEquals(1, cover[5 * WIDTH + 4], 1e-12);
    assertEquals(0.75, cover[5 * WIDTH + 5], 1e-12);
    assertEquals(0, cover[5 * WIDTH + 6], 1e-12);
    assertEquals(0, cover[7 * WIDTH + 4], 1e-12);
  }

  @Test
  void coverageOfTrianglesMatchesSampledPoints() {
    SeededRandom random = new SeededRandom(3, "triangles");
    CoverageRaster raster = new CoverageRaster(WIDTH, HEIGHT);
    for (int i = 0; i < 200; i++) {
      double[] x = new double[3];
      double[] y = new double[3];
      for (int k = 0; k < 3; k++) {
        // some corners lie beyond the sensor on each side
        x[k] = random.between(-12, WIDTH + 12);
        y[k] = random.between(-12, HEIGHT + 12);
      }
      raster.clear();
      raster.add(x, y, 3);
      double[] cover = cover(raster);
      for (int pixel = 0; pixel < cover.length; pixel += 7) {
        assertEquals(sampled(x, y, pixel % WIDTH, pixel / WIDTH), cover[pixel], 0.04);
      }
    }
  }

  private static double sampled(double[] x, double[] y, int column, int row) {
    int inside = 0;
    int fine = 40;
    for (int i = 0; i < fine * fine; i++) {
      double px = column - 0.5 + (i % fine + 0.5) / fine;
      double py = row - 0.5 + (i / fine + 0.5) / fine;
      int left = 0;
      for (int k = 0; k < 3; k++) {
        int next = (k + 1) % 3;
        double turn = (x[next] - x[k]) * (py - y[k]) - (y[next] - y[k]) * (px - x[k]);
        left += turn > 0 ? 1 : 0;
      }
      inside += left == 0 || left == 3 ? 1 : 0;
    }
    return (double) inside / (fine * fine);
  }
}
