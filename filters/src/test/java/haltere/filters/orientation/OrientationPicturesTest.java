package haltere.filters.orientation;

import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.simulation.internal.flight.FlightScene;
import haltere.core.simulation.internal.flight.FlightTruth;
import haltere.core.sink.internal.SvgPlot;
import haltere.filters.orientation.camera.Vectors;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/**
 * Draws the pictures of docs/orientation.md into build/pictures; {@code ./gradlew
 * :filters:refreshPictures} takes them over. Each test also says what its picture shows.
 */
class OrientationPicturesTest {
  private static final Path FOLDER = Path.of("build", "pictures");
  private static final String GREY = "#888888";
  private static final String BLUE = "#1f6fb4";
  private static final String RED = "#c23b22";
  private static final String GREEN = "#2f8f4e";
  private static final int PICTURES = 200;

  /** A flight with three cameras, as it was seen, looked back at, and was. */
  private static final class Flight {
    final List<OrientationEstimate> online = new ArrayList<>();
    final List<OrientationEstimate> smoothed;
    final List<FlightTruth> truth = new ArrayList<>();

    Flight(long seed) {
      FlightScene scene = Flights.scene(3, seed);
      OrientationTrack track =
          new OrientationTrack(Flights.cameras(scene), OrientationSettings.defaults());
      for (long k = 0; k < PICTURES; k++) {
        track
            .update(scene.pictureTimeUs(k), Flights.observations(scene, scene.detections(k)))
            .ifPresent(
                now -> {
                  online.add(now);
                  truth.add(scene.truthAt(now.timeUs()));
                });
      }
      smoothed = track.smoothed();
    }
  }

  private static double[] headings(List<double[]> axes) {
    double[] headings = new double[axes.size()];
    double before = Double.NaN;
    for (int i = 0; i < headings.length; i++) {
      double now = Math.toDegrees(Math.atan2(axes.get(i)[1], axes.get(i)[0]));
      while (now - before > 180) {
        now -= 360;
      }
      while (now - before < -180) {
        now += 360;
      }
      headings[i] = now;
      before = now;
    }
    return headings;
  }

  private static double[] axis(OrientationEstimate now) {
    return new double[] {now.ux(), now.uy(), now.uz()};
  }

  private static double[] errors(List<OrientationEstimate> estimates, List<FlightTruth> truth) {
    double[] errors = new double[estimates.size()];
    for (int i = 0; i < errors.length; i++) {
      FlightTruth t = truth.get(i);
      errors[i] =
          Math.toDegrees(
              Vectors.angle(axis(estimates.get(i)), new double[] {t.ux(), t.uy(), t.uz()}));
    }
    return errors;
  }

  private static void write(SvgPlot plot, String name, String title, String y) throws IOException {
    Path file = FOLDER.resolve("orientation-" + name + ".svg");
    plot.write(file, title, "time (s)", y);
    assertTrue(Files.size(file) < 40_000, "small enough to commit: " + Files.size(file));
  }

  @Test
  void headingIsFollowedThroughSaccades() throws IOException {
    Flight flight = new Flight(7);
    double[] t = flight.online.stream().mapToDouble(now -> now.timeUs() * 1e-6).toArray();
    double[] truth =
        headings(
            flight.truth.stream().map(at -> new double[] {at.ux(), at.uy(), at.uz()}).toList());
    double[] found = headings(flight.online.stream().map(now -> axis(now)).toList());
    double turns = 360 * Math.rint((found[50] - truth[50]) / 360);
    double least = Double.POSITIVE_INFINITY;
    double most = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < t.length; i++) {
      found[i] -= turns;
      least = Math.min(least, truth[i]);
      most = Math.max(most, truth[i]);
    }
    SvgPlot plot =
        new SvgPlot(0, 2, least - 15, most + 15)
            .line("truth", GREY, t, truth)
            .dots("from three cameras, online", BLUE, t, found);
    write(plot, "heading", "Heading of a body in free flight, with saccades", "heading (deg)");
    double[] errors = errors(flight.online, flight.truth);
    assertTrue(java.util.Arrays.stream(errors, 20, errors.length).max().orElseThrow() < 15);
  }

  @Test
  void errorMatchesItsDeviationAndSmoothingReducesIt() throws IOException {
    Flight flight = new Flight(7);
    double[] t = flight.online.stream().mapToDouble(now -> now.timeUs() * 1e-6).toArray();
    double[] online = errors(flight.online, flight.truth);
    double[] smoothed = errors(flight.smoothed, flight.truth);
    double[] sd =
        flight.online.stream().mapToDouble(now -> Math.toDegrees(now.sdAxisRad())).toArray();
    SvgPlot plot =
        new SvgPlot(0, 2, 0, 8)
            .line("what the filter expects (rms)", GREEN, t, sd)
            .line("error online", BLUE, t, online)
            .line("error after smoothing", RED, t, smoothed);
    write(plot, "error", "Angle between the estimated and the true axis", "angle (deg)");
    assertTrue(rms(smoothed) < rms(online), rms(online) + " to " + rms(smoothed));
    assertTrue(rms(online) < 1.5 * rms(sd) && rms(online) > 0.5 * rms(sd));
  }

  private static double rms(double[] values) {
    double sum = 0;
    for (double value : java.util.Arrays.stream(values, 20, values.length).toArray()) {
      sum += value * value;
    }
    return Math.sqrt(sum / (values.length - 20));
  }
}
