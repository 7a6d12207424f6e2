package haltere.testing.wings;

import haltere.core.simulation.internal.fly.FlyScene;
import haltere.core.simulation.internal.fly.FlySceneSettings;
import haltere.core.sink.internal.SvgPlot;
import haltere.filters.wing.WingTrackerSettings;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;

/**
 * Tracks many simulated flies, writes the figures of docs/wings.md and draws them: {@code ./gradlew
 * :src-test:evaluateWings -Pscenes=500 -PfirstSeed=1}.
 */
public final class WingEvaluation {
  private static final double SECONDS = 1;
  private static final int WRITTEN_EVERY = 25;
  private static final String STEADY = "#1f6fb4";
  private static final String MANOEUVRES = "#c23b22";
  private static final String TARGET = "#888888";
  private static final String EVENTS = "events an edge and beat, logarithm to base 10";

  /** A fly and how well it was tracked. */
  private record Result(
      long seed, FlySceneSettings scene, double eventsPerEdge, WingScores usual, WingScores known) {
    boolean manoeuvres() {
      return scene.disturbances().manoeuvres().everyS() > 0;
    }
  }

  private WingEvaluation() {}

  /**
   * Runs.
   *
   * @param args number of scenes, first seed, folder of the result
   * @throws IOException if the result cannot be written
   */
  public static void main(String[] args) throws IOException {
    int scenes = Integer.parseInt(args[0]);
    long firstSeed = Long.parseLong(args[1]);
    Path folder = Path.of(args[2]);
    Files.createDirectories(folder);
    List<Result> results = new ArrayList<>();
    List<Result> heavy = new ArrayList<>();
    for (long seed = firstSeed; seed < firstSeed + scenes; seed++) {
      results.add(track(seed, RandomFlies.random(seed)));
      if (heavy.size() < Math.max(4, scenes / 10)) {
        heavy.add(track(seed, RandomFlies.heavyNoise(seed)));
      }
      // a run that is ended early leaves its figures as well
      if (results.size() % WRITTEN_EVERY == 0 || results.size() == scenes) {
        Files.writeString(folder.resolve("wings-figures.md"), figures(results, heavy));
        draw(results, folder);
      }
    }
    System.out.print(figures(results, heavy));
  }

  private static String figures(List<Result> results, List<Result> heavy) {
    StringBuilder text = new StringBuilder();
    table(text, "all scenes of at least 100 events an edge and beat", enough(results));
    table(
        text, "steady among them", enough(results).stream().filter(r -> !r.manoeuvres()).toList());
    table(
        text,
        "with manoeuvres among them",
        enough(results).stream().filter(Result::manoeuvres).toList());
    table(
        text,
        "fewer than 100 events an edge and beat",
        results.stream().filter(r -> r.eventsPerEdge < 100).toList());
    table(text, "heavy noise", heavy);
    worst(text, enough(results));
    return text.toString();
  }

  private static void draw(List<Result> results, Path folder) throws IOException {
    SvgPlot angle = new SvgPlot(1, 4, 0, 4).level("target 1.2\u00b0", TARGET, 1.2);
    dots(angle, results, r -> r.known.angleDeg());
    angle.write(
        folder.resolve("wings-scenes-angle.svg"),
        "Angle of a wing, RMS of each scene, latency of the camera known",
        EVENTS,
        "degrees");
    SvgPlot frequency = new SvgPlot(1, 4, 0, 1);
    dots(frequency, results, r -> r.usual.frequencyHz());
    frequency
        .level("target 0.15 Hz", STEADY, 0.15)
        .level("target 0.6 Hz", MANOEUVRES, 0.6)
        .write(
            folder.resolve("wings-scenes-frequency.svg"),
            "Beat frequency, RMS of each scene",
            EVENTS,
            "hertz");
  }

  /** Draws values beyond the picture at its upper edge. */
  private static void dots(SvgPlot plot, List<Result> results, ToDoubleFunction<Result> value) {
    for (boolean manoeuvres : new boolean[] {false, true}) {
      List<Result> kind =
          results.stream()
              .filter(WingEvaluation::locked)
              .filter(r -> r.manoeuvres() == manoeuvres)
              .toList();
      plot.dots(
          manoeuvres ? "with manoeuvres" : "steady",
          manoeuvres ? MANOEUVRES : STEADY,
          kind.stream().mapToDouble(r -> Math.log10(r.eventsPerEdge)).toArray(),
          kind.stream().mapToDouble(value).toArray());
    }
  }

  private static List<Result> enough(List<Result> results) {
    return results.stream().filter(r -> r.eventsPerEdge >= 100).toList();
  }

  private static Result track(long seed, FlySceneSettings scene) {
    FlyScene events = new FlyScene(scene);
    WingScores usual = new WingScores(events, WingTrackerSettings.defaults());
    double latency = scene.pixel().latencyUs();
    WingScores known =
        new WingScores(events, WingTrackerSettings.defaults().with("filter.latencyUs=" + latency));
    WingScores.run(events, SECONDS, usual, known);
    return new Result(
        seed,
        scene,
        RandomFlies.eventsPerEdgeAndBeat(scene, usual.events(), SECONDS),
        usual,
        known);
  }

  private static boolean locked(Result r) {
    return r.usual.isLocked();
  }

  private static void table(StringBuilder text, String name, List<Result> results) {
    List<Result> found = results.stream().filter(WingEvaluation::locked).toList();
    line(text, "### %s: %d scenes", name, results.size());
    line(text, "");
    line(
        text,
        "locked %d of %d, found after (ms) median %.0f most %.0f",
        found.size(),
        results.size(),
        Quantiles.of(found, r -> r.usual.foundAtUs() / 1000.0, 0.5),
        Quantiles.of(found, r -> r.usual.foundAtUs() / 1000.0, 1));
    line(text, "");
    line(text, "| RMS | median scene | 90 %% of scenes | worst scene |");
    line(text, "| --- | --- | --- | --- |");
    row(text, "frequency (Hz)", found, r -> r.usual.frequencyHz());
    row(text, "angle, latency of the camera known (deg)", found, r -> r.known.angleDeg());
    row(text, "same, heading's error apart (deg)", found, r -> r.known.angleOfStrokeDeg());
    row(text, "same, at the reversals (deg)", found, r -> r.known.reversalDeg());
    row(text, "angle, all defaults (deg)", found, r -> r.usual.angleDeg());
    row(text, "amplitude of a beat (deg)", found, r -> r.usual.amplitudeDeg());
    row(text, "amplitude bias (deg)", found, r -> Math.abs(r.usual.amplitudeBiasDeg()));
    row(text, "phase between the wings (deg)", found, r -> r.usual.lagDeg());
    row(text, "body centre (px)", found, r -> r.usual.centrePx());
    row(text, "heading (deg)", found, r -> r.usual.headingDeg());
    row(text, "mean NIS", found, r -> r.usual.meanNis());
    row(text, "NEES of the frequency", found, r -> r.usual.neesFrequency());
    row(text, "NEES of the angle", found, r -> r.known.neesAngle());
    line(
        text,
        "| head and tail right | %d of %d | | |",
        found.stream().filter(r -> r.usual.headingDeg() < 90).count(),
        found.size());
    line(
        text,
        "| mean NIS in 0.95 to 1.05 | %d of %d | | |",
        found.stream().filter(WingEvaluation::isNisInside).count(),
        found.size());
    inBand(text, "NEES of the frequency", found, r -> r.usual.frequencyErrors());
    inBand(text, "NEES of the angle", found, r -> r.known.angleErrors());
    line(text, "");
  }

  /** Steady flight and manoeuvres have a band each: errors follow each other in other ways. */
  private static void inBand(
      StringBuilder text,
      String name,
      List<Result> found,
      Function<Result, NormalisedErrors[]> errors) {
    int inside = 0;
    StringBuilder bands = new StringBuilder();
    for (boolean manoeuvres : new boolean[] {false, true}) {
      List<NormalisedErrors[]> kind =
          found.stream().filter(r -> r.manoeuvres() == manoeuvres).map(errors).toList();
      if (!kind.isEmpty()) {
        NeesBand band = NeesBand.of(kind);
        inside += band.count(kind);
        bands.append(String.format(Locale.ROOT, " %.2f to %.2f", band.min(), band.max()));
      }
    }
    line(text, "| %s in its band | %d of %d |%s | |", name, inside, found.size(), bands);
  }

  private static void worst(StringBuilder text, List<Result> results) {
    List<Result> found = results.stream().filter(WingEvaluation::locked).toList();
    seeds(text, "not locked", results, r -> !locked(r));
    seeds(text, "head for tail", found, r -> r.usual.headingDeg() > 90);
    seeds(text, "angle above 1.2 degrees", found, r -> r.known.angleOfStrokeDeg() > 1.2);
    seeds(text, "mean NIS outside", found, r -> !isNisInside(r));
  }

  private static boolean isNisInside(Result r) {
    return Math.abs(r.usual.meanNis() - 1) <= 0.05;
  }

  private static void seeds(
      StringBuilder text, String what, List<Result> results, Predicate<Result> which) {
    line(text, "%s: seeds %s", what, results.stream().filter(which).map(Result::seed).toList());
  }

  private static void row(
      StringBuilder text, String name, List<Result> results, ToDoubleFunction<Result> value) {
    line(
        text,
        "| %s | %.3f | %.3f | %.3f |",
        name,
        Quantiles.of(results, value, 0.5),
        Quantiles.of(results, value, 0.9),
        Quantiles.of(results, value, 1));
  }

  private static void line(StringBuilder text, String format, Object... values) {
    text.append(String.format(Locale.ROOT, format, values)).append('\n');
  }
}
