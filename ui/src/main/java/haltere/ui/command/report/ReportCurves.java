package haltere.ui.command.report;

import haltere.core.format.summary.TimeBins;
import haltere.core.sink.internal.SvgPlot;
import haltere.ui.plot.PlotField;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/**
 * Curves of a lane over a whole stream in bounded memory: minima and maxima in time bins, and the
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
      return IntStream.range(0, bins.size())
          .filter(bin -> bins.count(bin) > 0)
          .mapToDouble(bin -> (baseUs + (bin + 0.5) * bins.binUs()) * 1e-6)
          .toArray();
    }

    double[] edge(boolean low) {
      return IntStream.range(0, bins.size())
          .filter(bin -> bins.count(bin) > 0)
          .mapToDouble(bin -> low ? bins.min(bin) : bins.max(bin))
          .toArray();
    }

    boolean isDense() {
      return samples > (long) DENSE * bins.size();
    }
  }

  private final List<PlotField> fields;
  private final Map<String, ReportCurve> traces = new LinkedHashMap<>();

  /** Curves of nothing yet. */
  ReportCurves(List<PlotField> fields) {
    this.fields = fields;
  }

  List<PlotField> fields() {
    return fields;
  }

  /** Takes a sample; times ascend; one that is not a number is left out. */
  void take(PlotField field, long timeUs, String key, double value) {
    String name =
        fields.size() == 1
            ? key
            : field.outlet() + " " + field.label() + (key.isEmpty() ? "" : ", " + key);
    if (Double.isFinite(value) && (traces.size() < MAX_CURVES || traces.containsKey(name))) {
      traces.computeIfAbsent(name, absent -> new ReportCurve()).add(timeUs, value);
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
    PlotField first = fields.get(0);
    String label = first.label() + (first.unit().isEmpty() ? "" : " (" + first.unit() + ")");
    String title = first.title();
    List<ReportCurve> all = List.copyOf(traces.values());
    double[] allTimes = join(all.stream().map(trace -> trace.timesS()).toList());
    SvgPlot whole =
        SvgPlot.around(
            allTimes,
            join(all.stream().map(trace -> trace.edge(true)).toList()),
            join(all.stream().map(trace -> trace.edge(false)).toList()));
    Map<String, String> colours = colours();
    traces.forEach(
        (key, trace) -> {
          double[] low = trace.edge(true);
          double[] high = trace.edge(false);
          double[] middle =
              IntStream.range(0, low.length).mapToDouble(i -> (low[i] + high[i]) / 2).toArray();
          double[] times = trace.timesS();
          whole.band("", colours.get(key), times, low, high);
          whole.line("", colours.get(key), times, middle);
        });
    Map<String, String> legend =
        traces.size() <= MAX_NAMED && !traces.containsKey("") ? colours : Map.of();
    boolean dense = all.stream().anyMatch(ReportCurve::isDense);
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
    List<double[]> times = new ArrayList<>();
    List<double[]> values = new ArrayList<>();
    for (ReportCurve trace : traces.values()) {
      times.add(trace.newest.stream().mapToDouble(now -> now.timeUs * 1e-6).toArray());
      values.add(trace.newest.stream().mapToDouble(Sample::value).toArray());
    }
    SvgPlot plot = SvgPlot.around(join(times), join(values));
    int number = 0;
    for (String key : traces.keySet()) {
      plot.line("", colours.get(key), times.get(number), values.get(number++));
    }
    return plot;
  }

  private static double[] join(List<double[]> parts) {
    return parts.stream().flatMapToDouble(java.util.Arrays::stream).toArray();
  }
}
