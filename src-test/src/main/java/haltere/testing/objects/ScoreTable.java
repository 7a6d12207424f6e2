package haltere.testing.objects;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.ToDoubleFunction;

/** Scores of scenes by kind, as a table in Markdown. Thread rule: one thread at a time. */
public final class ScoreTable {
  private static final String HEADER =
      """
      | | scenes | IDF1 mean | worst | MOTA mean | worst | HOTA | covered | tracks on it | identities \
      | elsewhere | off centre | velocity error % | position in 95 % | velocity in 95 % | latency s |
      | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |
      """;

  private final Map<String, List<ObjectScore>> byKind = new LinkedHashMap<>();

  /** An empty table. */
  public ScoreTable() {
    // the field is enough
  }

  /**
   * Adds a scene.
   *
   * @param kind class of scenes under which it is reported
   * @param score its score
   */
  public void add(String kind, ObjectScore score) {
    byKind.computeIfAbsent(kind, k -> new ArrayList<>()).add(score);
  }

  @Override
  public String toString() {
    StringBuilder text = new StringBuilder(HEADER);
    byKind.forEach((kind, scores) -> text.append(line(kind, scores)));
    if (byKind.size() > 1) {
      text.append(line("all", byKind.values().stream().flatMap(List::stream).toList()));
    }
    return text.toString();
  }

  /** Means over the scenes; velocity errors and shares over all of their points. */
  private static String line(String kind, List<ObjectScore> scores) {
    double errors = 0;
    double speeds = 0;
    ObjectScore.Within position = new ObjectScore.Within(0, 0);
    ObjectScore.Within velocity = new ObjectScore.Within(0, 0);
    for (ObjectScore score : scores) {
      long pairs = score.accuracy().velocityPairs();
      double rmse = score.accuracy().velocityRmse();
      double relative = score.accuracy().relativeVelocityRmse();
      if (pairs > 0 && rmse > 0 && Double.isFinite(relative)) {
        errors += pairs * rmse * rmse;
        speeds += pairs * (rmse / relative) * (rmse / relative);
      }
      position = position.plus(score.position());
      velocity = velocity.plus(score.velocity());
    }
    return String.format(
        Locale.ROOT,
        "| %s | %d | %.3f | %.3f | %.3f | %.3f | %.3f | %.3f | %.2f | %.2f | %.3f | %.2f | %s | %s | %s | %.2f |%n",
        kind,
        scores.size(),
        mean(scores, ObjectScore::idf1),
        worst(scores, ObjectScore::idf1),
        mean(scores, ObjectScore::mota),
        worst(scores, ObjectScore::mota),
        mean(scores, ObjectScore::hota),
        mean(scores, ObjectScore::covered),
        mean(scores, ObjectScore::tracksOnIt),
        mean(scores, ObjectScore::identities),
        mean(scores, ObjectScore::elsewhere),
        mean(scores, ObjectScore::offCentre),
        percent(Math.sqrt(errors / speeds)),
        percent(position.share()),
        percent(velocity.share()),
        mean(scores, ObjectScore::latencyS));
  }

  private static String percent(double share) {
    return Double.isNaN(share) ? "" : String.format(Locale.ROOT, "%.1f", 100 * share);
  }

  private static double mean(List<ObjectScore> scores, ToDoubleFunction<ObjectScore> value) {
    return scores.stream().mapToDouble(value).average().orElse(Double.NaN);
  }

  private static double worst(List<ObjectScore> scores, ToDoubleFunction<ObjectScore> value) {
    return scores.stream().mapToDouble(value).min().orElse(Double.NaN);
  }
}
