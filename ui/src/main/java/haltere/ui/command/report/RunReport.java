package haltere.ui.command.report;

import haltere.core.chain.ChainFile;
import haltere.core.chain.FilterChain;
import haltere.core.chain.Outlet;
import haltere.core.format.summary.EventRate;
import haltere.core.format.summary.TimeBins;
import haltere.core.pipeline.JobReport;
import haltere.core.pipeline.JobResults;
import haltere.core.pipeline.PipelineCounters.Counter;
import haltere.core.pipeline.RecordingJob;
import haltere.core.playback.PlaybackClock;
import haltere.core.playback.Sleeper;
import haltere.core.playback.internal.PacedSource;
import haltere.core.sink.internal.SvgPlot;
import haltere.core.stream.EventSource;
import haltere.core.stream.StreamHandler;
import haltere.ui.command.terminal.Quantities;
import haltere.ui.plot.PlotField;
import haltere.ui.plot.PlotSet;
import haltere.ui.rendering.ContactSheet;
import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/**
 * Report of a recording and its chain, collected during the job in bounded memory.
 *
 * <p>Thread rule: the thread of the job.
 */
public final class RunReport implements JobResults {
  private static final int RATE_BINS = 400;
  private static final String TIME = "time from the first event (s)";

  private final EventRate rate = new EventRate(RATE_BINS);
  private final List<ReportCurves> curves = new ArrayList<>();
  private List<ObjectTable> objects = List.of();
  private FilterChain chain;
  private ContactSheet sheet;
  private List<List<String>> stages = List.of();
  private String chainText = "";

  /** Another job that does the same and is watched for the report. */
  public RecordingJob watching(RecordingJob job) {
    return job.withResults((reader, filters) -> open(filters))
        .withPacing(RunReport::inShortPackets);
  }

  /** In packets of milliseconds, so that pictures show events and results of the same moment. */
  static EventSource inShortPackets(EventSource source) {
    PlaybackClock unlimited = new PlaybackClock(System::nanoTime, Sleeper.real());
    unlimited.setSpeed(Double.POSITIVE_INFINITY);
    return new PacedSource(source, unlimited);
  }

  private JobResults open(FilterChain filters) {
    chain = filters;
    sheet = new ContactSheet(filters);
    objects = ObjectTable.of(filters);
    for (PlotField field : PlotSet.main(PlotField.of(filters))) {
      plot(field, field.find(filters).orElseThrow());
    }
    return this;
  }

  /**
   * Plots a field of results over the time since the first event, also where the clock restarts.
   */
  public void plot(PlotField field, Outlet<?> results) {
    curves.add(new ReportCurves(field, results, us -> rate.elapsedUs() + us - rate.lastUs()));
  }

  @Override
  public List<StreamHandler> rawSinks() {
    return List.of(rate);
  }

  @Override
  public List<StreamHandler> sinks() {
    return List.of(sheet);
  }

  @Override
  public void finish() {
    chainText = ChainFile.write(chain);
    stages = ChainTable.rows(chain);
  }

  /**
   * Adds the collected data to a page, with the recording's SHA-256 (hexadecimal) and lines of
   * text.
   */
  public void addTo(ReportPage page, JobReport job, String sha256, List<String> summary)
      throws IOException {
    long events = job.counters().get(Counter.EVENTS_IN);
    Map<String, String> read = new LinkedHashMap<>();
    read.put("Recording", job.recording().toString());
    read.put("SHA-256", sha256);
    read.put("Size", Quantities.count(job.bytes()) + " bytes");
    read.put("Format", job.format());
    read.put("Sensor", job.sensor() + " pixels");
    read.put("Events", Quantities.count(events));
    if (events > 0) {
      double durationS = rate.elapsedUs() * 1e-6;
      read.put(
          "Time", Quantities.seconds(rate.firstUs()) + " to " + Quantities.seconds(rate.lastUs()));
      read.put("Duration", Quantities.text("%.6f s", durationS));
      read.put("Mean rate", Quantities.rate(durationS > 0 ? events / durationS : 0));
    }
    if (!job.samples().isEmpty()) {
      read.put("Also", job.samples().toString());
    }
    read.put("Warnings", job.warnings().isEmpty() ? "none" : String.join("\n", job.warnings()));
    page.section("Input");
    page.facts(read);
    page.section("Chain");
    page.table(ChainTable.HEADER, stages);
    if (!summary.isEmpty() || !job.files().isEmpty()) {
      page.section("Results");
    }
    if (!summary.isEmpty()) {
      page.text(summary);
    }
    if (!job.files().isEmpty()) {
      page.table(
          List.of("file", "rows"),
          job.files().stream()
              .map(file -> List.of(file.path().toString(), Quantities.count(file.rows())))
              .toList());
    }
    objects.forEach(table -> table.addTo(page, rate.firstUs()));
    page.section("Pictures of events and results");
    page.sentence("Orange: brighter (ON), blue: darker (OFF); times count from the first event.");
    page.picture(sheet.draw(), "The recording with the results at up to eight moments");
    page.section("Plots");
    addRate(page);
    curves.forEach(curve -> curve.addTo(page, TIME));
    page.folded("The chain as a file", List.of(chainText.strip()));
  }

  private void addRate(ReportPage page) {
    TimeBins bins = rate.bins();
    if (bins.size() > 1) {
      double[] timesS =
          IntStream.range(0, bins.size())
              .mapToDouble(bin -> (bin + 0.5) * bins.binUs() * 1e-6)
              .toArray();
      double[] kevS =
          IntStream.range(0, bins.size()).mapToDouble(bin -> bins.rateHz(bin) * 1e-3).toArray();
      page.plot(
          SvgPlot.around(timesS, kevS)
              .line("", ReportPage.colour("", 0), timesS, kevS)
              .draw("Event rate of the recording", TIME, "event rate (kev/s)"),
          Map.of(),
          "");
    }
  }
}
