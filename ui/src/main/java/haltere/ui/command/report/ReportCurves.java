package haltere.ui.command.report;

import haltere.core.chain.Outlet;
import haltere.core.format.summary.TimeBins;
import haltere.core.sink.internal.SvgPlot;
import haltere.ui.plot.PlotField;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Function;
import java.util.function.IntToDoubleFunction;
import java.util.function.LongUnaryOperator;
import java.util.stream.IntStream;

/**
 * Curves of a field over a whole stream in bounded memory: minima and maxima in time bins, and the
 * newest samples.
 */
final class ReportCurves {
  private static final int BINS = 400;
  private static final int NEWEST = 128;
  private static final int MAX_CURVES = 200;
  private static final int MAX_NAMED = 8;

  /** Samples in a bin from which on a close-up shows more. */
  private static final int DENSE = 4;

  private static final String BANDS =
      "Band: lowest to highest of each interval; line: the middle of both.";

  private record Sample(long timeUs, double value) {}

  private static final class ReportCurve {
    private final Deque<Sample> newest = new ArrayDeque<>();
    private final TimeBins bins = new TimeBins(BINS, 1_000);
    private long baseUs;
    private long samples;

    void add(long timeUs, double value) {
      baseUs = samples == 0 ? timeUs : baseUs;
      samples++;
      bins.add(Math.max(0, timeUs - baseUs), value);
      if (newest.size() == NEWEST) {
        newest.removeFirst();
      }
      newest.addLast(new Sample(timeUs, value));
    }

    double[] timesS() {
      return each(bin -> (baseUs + (bin + 0.5) * bins.binUs()) * 1e-6);
    }

    double[] each(IntToDoubleFunction ofBin) {
      IntStream filled = IntStream.range(0, bins.size()).filter(bin -> bins.count(bin) > 0);
      return filled.mapToDouble(ofBin).toArray();
    }

    double[] newestTimesS() {
      return newest.stream().mapToDouble(sample -> sample.timeUs * 1e-6).toArray();
    }

    double[] newestValues() {
      return newest.stream().mapToDouble(Sample::value).toArray();
    }

    boolean isDense() {
      return samples > (long) DENSE * bins.size();
    }
  }

  private final PlotField field;
  private final Map<String, ReportCurve> traces = new LinkedHashMap<>();

  /** Curves of a field of results, to which they subscribe, over other times than those of rows. */
  ReportCurves(PlotField field, Outlet<?> results, LongUnaryOperator plotUs) {
    this.field = field;
    field.listen(results, false, (us, key, value) -> take(plotUs.applyAsLong(us), key, value));
  }

  private void take(long timeUs, String key, double value) {
    if (Double.isFinite(value) && (traces.size() < MAX_CURVES || traces.containsKey(key))) {
      traces.computeIfAbsent(key, absent -> new ReportCurve()).add(timeUs, value);
    }
  }

  /**
   * Adds the plots to a page: the whole time, and a close-up if that hides the samples; with the
   * label of the time axis.
   */
  void addTo(ReportPage page, String timeLabel) {
    if (traces.isEmpty()) {
      return;
    }
    String label = field.label() + (field.unit().isEmpty() ? "" : " (" + field.unit() + ")");
    String title = field.title();
    SvgPlot whole =
        SvgPlot.around(
            join(ReportCurve::timesS),
            join(trace -> trace.each(trace.bins::min)),
            join(trace -> trace.each(trace.bins::max)));
    Map<String, String> colours = colours();
    traces.forEach(
        (key, trace) -> {
          TimeBins bins = trace.bins;
          double[] times = trace.timesS();
          double[] middle = trace.each(bin -> (bins.min(bin) + bins.max(bin)) / 2);
          whole.band("", colours.get(key), times, trace.each(bins::min), trace.each(bins::max));
          whole.line("", colours.get(key), times, middle);
        });
    Map<String, String> legend =
        traces.size() <= MAX_NAMED && !traces.containsKey("") ? colours : Map.of();
    boolean dense = traces.values().stream().anyMatch(ReportCurve::isDense);
    page.plot(whole.draw(title, timeLabel, label), legend, dense ? BANDS : "");
    if (dense) {
      String text = title + ", last " + NEWEST + " samples";
      page.plot(closeUp(colours).draw(text, timeLabel, label), legend, "");
    }
  }

  private Map<String, String> colours() {
    Map<String, String> colours = new LinkedHashMap<>();
    traces.keySet().forEach(key -> colours.put(key, ReportPage.colour(key, colours.size())));
    return colours;
  }

  private SvgPlot closeUp(Map<String, String> colours) {
    SvgPlot plot = SvgPlot.around(join(ReportCurve::newestTimesS), join(ReportCurve::newestValues));
    traces.forEach(
        (key, trace) ->
            plot.line("", colours.get(key), trace.newestTimesS(), trace.newestValues()));
    return plot;
  }

  private double[] join(Function<ReportCurve, double[]> part) {
    return traces.values().stream().map(part).flatMapToDouble(Arrays::stream).toArray();
  }
}
