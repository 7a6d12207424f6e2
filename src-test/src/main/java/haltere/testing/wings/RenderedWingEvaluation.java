package haltere.testing.wings;

import haltere.core.simulation.internal.fly.RenderedFlyScene;
import haltere.core.simulation.internal.fly.RenderedFlySceneSettings;
import haltere.core.sink.CsvSink;
import haltere.filters.wing.WingPart;
import haltere.filters.wing.WingTrackerSettings;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;

/**
 * Tracks many rendered flies and prints the errors of the angles, their stated deviations, and the
 * errors that repeat from beat to beat: {@code ./gradlew :src-test:evaluateRenderedWings
 * -Pscenes=100 -PfirstSeed=1}.
 */
public final class RenderedWingEvaluation {
  private static final double SECONDS = 1;
  private static final double CONSISTENT_RATIO = 1.3;

  /**
   * A fly and how well it was tracked, the latency of the camera stated; angles in degrees.
   *
   * @param seed of the fly
   * @param eventsPerEdge events of the wings an edge and beat
   * @param locked whether both wings were found, kept and on the right multiple of the beat
   * @param foundMs when
   * @param angleDeg RMS error of the angle of a wing
   * @param statedDeg RMS of the standard deviation that is stated
   * @param ratio of both
   * @param leftConstantDeg mean error of the left wing
   * @param rightConstantDeg mean error of the right wing
   * @param repeatingDeg RMS error that repeats from beat to beat, without the constant one
   * @param remainderDeg RMS of the rest
   * @param leftDelayUs delay that explains the error of the left wing best
   * @param rightDelayUs delay that explains the error of the right wing best
   * @param amplitudeDeg mean error of the amplitude
   * @param reversalDeg RMS error at the reversals
   * @param frequencyHz RMS error of the frequency
   * @param statedFrequencyHz RMS of its standard deviation that is stated
   * @param headingDeg RMS error of the heading
   * @param centrePx RMS error of the body centre
   * @param defaultAngleDeg RMS error of the angle with all defaults
   * @param defaultStatedDeg RMS of its standard deviation
   * @param meanNis mean normalised innovation squared
   */
  private record SceneRow(
      long seed,
      double eventsPerEdge,
      boolean locked,
      double foundMs,
      double angleDeg,
      double statedDeg,
      double ratio,
      double leftConstantDeg,
      double rightConstantDeg,
      double repeatingDeg,
      double remainderDeg,
      double leftDelayUs,
      double rightDelayUs,
      double amplitudeDeg,
      double reversalDeg,
      double frequencyHz,
      double statedFrequencyHz,
      double headingDeg,
      double centrePx,
      double defaultAngleDeg,
      double defaultStatedDeg,
      double meanNis) {}

  /**
   * Mean error of a wing or an edge in a part of the beat.
   *
   * @param seed of the fly
   * @param part which wing or edge
   * @param phaseRad middle of the part of the beat
   * @param errorDeg mean error there
   * @param rows estimates there
   */
  private record PhaseRow(long seed, WingPart part, double phaseRad, double errorDeg, long rows) {}

  private RenderedWingEvaluation() {}

  /**
   * Runs.
   *
   * @param args number of scenes, first seed, folder of the result, then settings of all scenes as
   *     {@code name=value}
   * @throws IOException if the result cannot be written
   */
  public static void main(String[] args) throws IOException {
    int scenes = Integer.parseInt(args[0]);
    long firstSeed = Long.parseLong(args[1]);
    Path folder = Path.of(args[2]);
    String[] assignments = Arrays.copyOfRange(args, 3, args.length);
    Files.createDirectories(folder);
    List<SceneRow> rows = new ArrayList<>();
    line(
        "seed events/edge locked  angle stated ratio  const-L const-R repeat rest"
            + "  delay-L delay-R  freq stated  heading");
    try (CsvSink<SceneRow> table =
            CsvSink.create(folder.resolve("scenes.csv"), SceneRow.class, true);
        CsvSink<PhaseRow> curves =
            CsvSink.create(folder.resolve("phase-errors.csv"), PhaseRow.class, true)) {
      for (long seed = firstSeed; seed < firstSeed + scenes; seed++) {
        SceneRow row = track(seed, RenderedFlies.random(seed).with(assignments), curves);
        rows.add(row);
        table.accept(row);
        print(row);
      }
      table.finish();
      curves.finish();
    }
    table("at least 100 events an edge and beat", 1.4, select(rows, r -> r.eventsPerEdge >= 100));
    table(
        "30 to 100 events an edge and beat",
        3.5,
        select(rows, r -> r.eventsPerEdge >= 30 && r.eventsPerEdge < 100));
    table("fewer than 30 events an edge and beat", 3.5, select(rows, r -> r.eventsPerEdge < 30));
  }

  private static List<SceneRow> select(List<SceneRow> rows, Predicate<SceneRow> which) {
    return rows.stream().filter(which).toList();
  }

  private static SceneRow track(
      long seed, RenderedFlySceneSettings scene, CsvSink<PhaseRow> curves) {
    RenderedFlyScene events = new RenderedFlyScene(scene);
    WingScores usual = new WingScores(events, WingTrackerSettings.defaults());
    double latency = scene.pixel().latencyUs();
    WingScores known =
        new WingScores(events, WingTrackerSettings.defaults().with("filter.latencyUs=" + latency));
    WingScores.run(events, SECONDS, usual, known);
    for (WingPart part : WingPart.values()) {
      PhaseErrors errors = known.phaseErrors(part);
      for (int bin = 0; bin < PhaseErrors.BINS; bin++) {
        curves.accept(
            new PhaseRow(
                seed,
                part,
                PhaseErrors.phaseRad(bin),
                Math.toDegrees(errors.meanRad(bin)),
                errors.count(bin)));
      }
    }
    PhaseErrors left = known.phaseErrors(WingPart.LEFT);
    PhaseErrors right = known.phaseErrors(WingPart.RIGHT);
    return new SceneRow(
        seed,
        RenderedFlies.eventsPerEdgeAndBeat(scene, known.events(), SECONDS),
        usual.isLocked() && known.isLocked(),
        known.foundAtUs() / 1000.0,
        known.angleDeg(),
        known.statedAngleDeg(),
        known.angleDeg() / known.statedAngleDeg(),
        Math.toDegrees(left.constantRad()),
        Math.toDegrees(right.constantRad()),
        both(left.repeatingRad(), right.repeatingRad()),
        both(left.remainderRad(), right.remainderRad()),
        delayUs(left, scene, scene.stroke().left().amplitudeRad()),
        delayUs(right, scene, scene.stroke().right().amplitudeRad()),
        known.amplitudeBiasDeg(),
        known.reversalDeg(),
        known.frequencyHz(),
        known.statedFrequencyHz(),
        known.headingDeg(),
        known.centrePx(),
        usual.angleDeg(),
        usual.statedAngleDeg(),
        known.meanNis());
  }

  private static double both(double leftRad, double rightRad) {
    return Math.toDegrees(Math.sqrt((leftRad * leftRad + rightRad * rightRad) / 2));
  }

  private static double delayUs(
      PhaseErrors errors, RenderedFlySceneSettings scene, double amplitudeRad) {
    double radPerS = 2 * Math.PI * scene.stroke().beat().frequencyHz() * amplitudeRad;
    return -1e6 * errors.withSpeedRad() / radPerS;
  }

  private static void print(SceneRow r) {
    line(
        "%4d %9.0f %6s  %6.2f %6.2f %5.2f  %7.2f %7.2f %6.2f %4.2f  %7.0f %7.0f  %5.2f %5.2f %7.2f",
        r.seed,
        r.eventsPerEdge,
        r.locked ? "yes" : "no",
        r.angleDeg,
        r.statedDeg,
        r.ratio,
        r.leftConstantDeg,
        r.rightConstantDeg,
        r.repeatingDeg,
        r.remainderDeg,
        r.leftDelayUs,
        r.rightDelayUs,
        r.frequencyHz,
        r.statedFrequencyHz,
        r.headingDeg);
  }

  private static void table(String name, double goalDeg, List<SceneRow> rows) {
    List<SceneRow> found = select(rows, SceneRow::locked);
    line("%n### %s: %d scenes, locked %d%n", name, rows.size(), found.size());
    line("| | median | 95 %% | worst |%n| --- | --- | --- | --- |");
    row("angle, RMS (deg)", found, r -> r.angleDeg);
    row("standard deviation stated (deg)", found, r -> r.statedDeg);
    row("ratio", found, r -> r.ratio);
    row("constant part (deg)", found, r -> both(r.leftConstantDeg, r.rightConstantDeg) * RAD);
    row("part that repeats (deg)", found, r -> r.repeatingDeg);
    row("rest (deg)", found, r -> r.remainderDeg);
    row("delay of a wing (us)", found, r -> Math.abs(r.leftDelayUs + r.rightDelayUs) / 2);
    row("amplitude (deg)", found, r -> Math.abs(r.amplitudeDeg));
    row("at the reversals (deg)", found, r -> r.reversalDeg);
    row("angle, all defaults (deg)", found, r -> r.defaultAngleDeg);
    row("frequency (Hz)", found, r -> r.frequencyHz);
    row("its standard deviation (Hz)", found, r -> r.statedFrequencyHz);
    row("heading (deg)", found, r -> r.headingDeg);
    row("body centre (px)", found, r -> r.centrePx);
    share("RMS at most 1.3 times what is stated", found, r -> r.ratio <= CONSISTENT_RATIO);
    share("angle within " + goalDeg + " degrees", found, r -> r.angleDeg <= goalDeg);
    share("both", found, r -> r.ratio <= CONSISTENT_RATIO && r.angleDeg <= goalDeg);
    line(
        "not locked: seeds %s", select(rows, r -> !r.locked).stream().map(SceneRow::seed).toList());
  }

  private static final double RAD = Math.PI / 180;

  private static void share(String name, List<SceneRow> rows, Predicate<SceneRow> which) {
    line("| %s | %d of %d | | |", name, select(rows, which).size(), rows.size());
  }

  private static void row(String name, List<SceneRow> rows, ToDoubleFunction<SceneRow> value) {
    line(
        "| %s | %.2f | %.2f | %.2f |",
        name,
        Quantiles.of(rows, value, 0.5),
        Quantiles.of(rows, value, 0.95),
        Quantiles.of(rows, value, 1));
  }

  private static void line(String format, Object... values) {
    System.out.println(String.format(Locale.ROOT, format, values));
  }
}
