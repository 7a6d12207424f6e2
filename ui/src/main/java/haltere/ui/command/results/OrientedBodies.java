package haltere.ui.command.results;

import haltere.filters.orientation.BodyOrientationEstimator;
import haltere.filters.orientation.OrientationCount;
import haltere.filters.orientation.OrientationEstimate;
import haltere.filters.orientation.OrientationSettings;
import haltere.filters.orientation.OrientationTrack;
import haltere.filters.orientation.camera.CameraModel;
import haltere.filters.orientation.camera.LineObservation;
import haltere.ui.command.terminal.Quantities;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;

/**
 * All bodies of a table: passes the observations of each time to each body's estimator and writes
 * the estimates in order of time; with smoothing, at the end.
 */
public final class OrientedBodies {
  private final List<CameraModel> cameras;
  private final OrientationSettings settings;
  private final boolean smooth;
  private final BiConsumer<String, OrientationEstimate> output;
  private final Map<String, BodyOrientationEstimator> bodies = new LinkedHashMap<>();
  private final Map<String, OrientationTrack> tracks = new LinkedHashMap<>();
  private final Map<String, List<LineObservation>> together = new LinkedHashMap<>();
  private long nowUs;
  private long observations;
  private long estimates;

  /**
   * Without bodies yet. The output gets each body's name and its estimates in order of time; with
   * smoothing, rows wait for later observations.
   */
  public OrientedBodies(
      List<CameraModel> cameras,
      OrientationSettings settings,
      boolean smooth,
      BiConsumer<String, OrientationEstimate> output) {
    this.cameras = cameras;
    this.settings = settings;
    this.smooth = smooth;
    this.output = output;
  }

  /** Takes an observation; times ascend. */
  public void observed(long timeUs, String object, LineObservation line) {
    if (timeUs != nowUs) {
      goOn();
      nowUs = timeUs;
    }
    observations++;
    together.computeIfAbsent(object, name -> new ArrayList<>()).add(line);
  }

  /** Observations so far. */
  public long observations() {
    return observations;
  }

  private void goOn() {
    for (Map.Entry<String, List<LineObservation>> each : together.entrySet()) {
      String object = each.getKey();
      if (smooth) {
        tracks
            .computeIfAbsent(object, name -> new OrientationTrack(cameras, settings))
            .update(nowUs, each.getValue());
      } else {
        Optional<OrientationEstimate> now =
            bodies
                .computeIfAbsent(object, name -> new BodyOrientationEstimator(cameras, settings))
                .update(nowUs, each.getValue());
        now.ifPresent(estimate -> write(object, estimate));
      }
    }
    together.clear();
  }

  /** Processes remaining observations and writes deferred rows. */
  public void finish() {
    goOn();
    List<Map.Entry<String, OrientationEstimate>> rows = new ArrayList<>();
    tracks.forEach(
        (object, track) ->
            track.smoothed().forEach(estimate -> rows.add(Map.entry(object, estimate))));
    rows.sort(Comparator.comparingLong(row -> row.getValue().timeUs()));
    rows.forEach(row -> write(row.getKey(), row.getValue()));
    tracks.forEach((object, track) -> bodies.put(object, track.estimator()));
  }

  private void write(String object, OrientationEstimate estimate) {
    estimates++;
    output.accept(object, estimate);
  }

  /** Estimates that were written so far. */
  public long estimates() {
    return estimates;
  }

  /** Counts of observations by result, a line for each. */
  public List<String> summary() {
    List<String> lines = new ArrayList<>();
    lines.add(
        Quantities.text(
            "%s of %d %s, %s",
            Quantities.counted(observations, "observation"),
            bodies.size(),
            bodies.size() == 1 ? "body" : "bodies",
            Quantities.counted(estimates, "estimate")));
    for (OrientationCount count : OrientationCount.values()) {
      long sum = bodies.values().stream().mapToLong(body -> body.count(count)).sum();
      if (sum > 0 || count == OrientationCount.USED || count == OrientationCount.REJECTED) {
        lines.add(Quantities.text("%12s %s", Quantities.count(sum), count.description()));
      }
    }
    bodies.forEach((object, body) -> lines.add("body " + object + ": " + noise(body)));
    if (estimates > 0) {
      lines.add("roll is not seen by any camera: its standard deviation is 104 deg throughout");
    }
    return lines;
  }

  /** Noise of a body's lines, and its ratio to the expected one. */
  private String noise(BodyOrientationEstimator body) {
    if (Double.isNaN(body.meanNis())) {
      return "no line was compared with an axis";
    }
    List<String> noise = new ArrayList<>();
    for (int i = 0; i < cameras.size(); i++) {
      if (cameras.get(i).problem().isEmpty()) {
        double sdDeg = Math.toDegrees(body.lineSdRad(i));
        noise.add(Quantities.text("%s %.1f", cameras.get(i).id(), sdDeg));
      }
    }
    return Quantities.text(
        "mean NIS %.2f, noise of the angles (deg) %s", body.meanNis(), String.join(", ", noise));
  }
}
