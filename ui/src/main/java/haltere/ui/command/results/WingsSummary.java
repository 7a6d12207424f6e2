package haltere.ui.command.results;

import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.stream.StreamHandler;
import haltere.filters.wing.FlyGeometry;
import haltere.filters.wing.WingBeat;
import haltere.filters.wing.WingEstimate;
import haltere.filters.wing.WingPart;
import haltere.filters.wing.WingTrackerState;
import haltere.filters.wing.tracker.WingTrackerFilter;
import haltere.ui.command.terminal.Quantities;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Summary of a recording with tracked wings: beats, frequency and amplitude of each side, time in
 * lock, mean position of the fly.
 */
public final class WingsSummary implements StreamHandler {
  private static final double DEGREES = 180 / Math.PI;

  private final WingTrackerFilter filter;
  private final double rateHz;
  private final double[] beats = new double[2];
  private final double[] frequency = new double[2];
  private final double[] frequencySquares = new double[2];
  private final double[] amplitude = new double[2];
  private final double[] amplitudeSquares = new double[2];
  private long tickUs = Long.MIN_VALUE;
  private long lastUs = Long.MAX_VALUE;
  private long spannedUs;
  private long bothTicks;
  private long oneTicks;
  private long unlockedTicks;
  private int losses;
  private double nis;
  private long nisCount;
  private FlyGeometry last;
  private double means;
  private final double[] sums = new double[8];
  private String condition = "waiting for wings";

  /** Without results yet, of a filter with a rate of estimates per second of recording time. */
  public WingsSummary(WingTrackerFilter filter, double rateHz) {
    this.filter = filter;
    this.rateHz = rateHz;
  }

  /** Subscribes to the results of the chain's wing tracker. */
  public void listenTo(FilterChain chain) {
    chain.outlet("beats", WingBeat.class).subscribe(this::beat);
    chain.outlet("wings", WingEstimate.class).subscribe(this::estimate);
    chain.outlet("initialisation", WingTrackerState.class).subscribe(this::state);
    chain.outlet("geometry", FlyGeometry.class).subscribe(this::found);
  }

  private void beat(WingBeat beat) {
    int side = beat.side() == WingPart.LEFT ? 0 : 1;
    beats[side]++;
    frequency[side] += beat.frequencyHz();
    frequencySquares[side] += beat.frequencyHz() * beat.frequencyHz();
    amplitude[side] += beat.amplitudeRad();
    amplitudeSquares[side] += beat.amplitudeRad() * beat.amplitudeRad();
  }

  private void found(FlyGeometry geometry) {
    last = geometry;
    means = 0;
    java.util.Arrays.fill(sums, 0);
  }

  private void estimate(WingEstimate estimate) {
    if (estimate.timeUs() == tickUs) {
      return;
    }
    tickUs = estimate.timeUs();
    switch (filter.tracker().phase()) {
      case TRACKING -> bothTicks++;
      case UNLOCKED -> unlockedTicks++;
      default -> oneTicks++;
    }
    double now = filter.tracker().meanNis();
    if (Double.isFinite(now)) {
      nis += now;
      nisCount++;
    }
    last = filter.tracker().geometry().orElseThrow();
    means++;
    sums[0] += last.centreX();
    sums[1] += last.centreY();
    sums[2] += Math.cos(last.headingRad());
    sums[3] += Math.sin(last.headingRad());
    sums[4] += last.leftHingeX();
    sums[5] += last.leftHingeY();
    sums[6] += last.rightHingeX();
    sums[7] += last.rightHingeY();
  }

  private void state(WingTrackerState state) {
    switch (state.phase()) {
      case TRACKING -> condition = "both wings tracked";
      case ONE_WING -> condition = "one wing tracked";
      case UNLOCKED -> condition = "wings followed at another frequency than the beat's";
      case LOST -> {
        condition = "wings lost";
        losses++;
      }
      default -> {
        // an intermediate step
      }
    }
  }

  @Override
  public void packet(EventPacket packet) {
    if (!packet.isEmpty()) {
      // a clock restart begins a new interval
      long fromUs = Math.min(lastUs, packet.firstTimeUs());
      lastUs = packet.lastTimeUs();
      spannedUs += lastUs - fromUs;
    }
  }

  /**
   * Mean position of the fly since it was last found, by the keys of {@code --geometry}; all values
   * are null without a fly.
   */
  public Map<String, Object> geometry() {
    Map<String, Object> map = new LinkedHashMap<>();
    boolean averaged = last != null && means > 0;
    double heading = averaged ? Math.atan2(sums[3], sums[2]) : last == null ? 0 : last.headingRad();
    map.put("centreX", last == null ? null : averaged ? sums[0] / means : last.centreX());
    map.put("centreY", last == null ? null : averaged ? sums[1] / means : last.centreY());
    map.put("headingRad", last == null ? null : heading < 0 ? heading + 2 * Math.PI : heading);
    map.put("sizePx", last == null ? null : last.sizePx());
    map.put("leftHingeX", last == null ? null : averaged ? sums[4] / means : last.leftHingeX());
    map.put("leftHingeY", last == null ? null : averaged ? sums[5] / means : last.leftHingeY());
    map.put("rightHingeX", last == null ? null : averaged ? sums[6] / means : last.rightHingeX());
    map.put("rightHingeY", last == null ? null : averaged ? sums[7] / means : last.rightHingeY());
    map.put("headTailConfidence", last == null ? null : last.headTailConfidence());
    map.put("initialisedAtUs", last == null ? null : last.initialisedAtUs());
    return map;
  }

  /** The summary, as lines of text. */
  public List<String> lines() {
    List<String> lines = new ArrayList<>();
    lines.add(
        Quantities.text(
            "%-6s %8s %12s %10s %15s %10s", "side", "beats", "frequency", "SD", "amplitude", "SD"));
    for (int side = 0; side < 2; side++) {
      double n = beats[side];
      String name = side == 0 ? "left" : "right";
      lines.add(
          n == 0
              ? Quantities.text("%-6s %8d", name, 0)
              : Quantities.text(
                  "%-6s %8.0f %9.2f Hz %7.2f Hz %11.2f deg %6.2f deg",
                  name,
                  n,
                  frequency[side] / n,
                  sd(frequency[side], frequencySquares[side], n),
                  amplitude[side] / n * DEGREES,
                  sd(amplitude[side], amplitudeSquares[side], n) * DEGREES));
    }
    double ticks = Math.max(1, spannedUs * 1e-6 * rateHz);
    lines.add(
        Quantities.text(
            "in lock %.1f %% of the time (one wing %.1f %%%s), lost %d times, at the end: %s",
            Math.min(100, 100 * bothTicks / ticks),
            Math.min(100, 100 * oneTicks / ticks),
            unlockedTicks == 0
                ? ""
                : Quantities.text(
                    ", at another frequency than the beat's %.1f %%",
                    Math.min(100, 100 * unlockedTicks / ticks)),
            losses,
            condition));
    filter
        .tracker()
        .averageGeometry()
        .ifPresent(
            body ->
                lines.add(
                    Quantities.text(
                        "body of the running average at the end: %.1f, %.1f px, heading %.3f rad",
                        body.centreX(), body.centreY(), body.headingRad())));
    if (nisCount > 0) {
      lines.add(Quantities.text("mean NIS %.3f", nis / nisCount));
    }
    return lines;
  }

  private static double sd(double sum, double squares, double n) {
    return Math.sqrt(Math.max(0, squares / n - sum / n * (sum / n)));
  }
}
