package haltere.ui.command.report;

import haltere.core.batch.BatchFailure;
import haltere.core.batch.BatchItem;
import haltere.core.chain.ChainFile;
import haltere.core.chain.FilterChain;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.format.internal.csv.CsvTable;
import haltere.core.format.summary.EventRate;
import haltere.core.json.internal.Json;
import haltere.core.pipeline.ChainRunner;
import haltere.core.pipeline.OnFailure;
import haltere.core.pipeline.PipelineCounters;
import haltere.core.pipeline.RecordingJob;
import haltere.core.sink.Tables;
import haltere.core.sink.internal.SvgPlot;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.EventSource;
import haltere.ui.command.terminal.Quantities;
import haltere.ui.plot.PlotField;
import haltere.ui.plot.PlotSet;
import haltere.ui.rendering.ContactSheet;
import java.awt.image.BufferedImage;
import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Report of a folder of results: counts of each recording and means of its main results, from
 * {@code done.json} and the tables. It is the same after a resumed or a shared run.
 *
 * @param folder where the results are
 * @param chains makes the chain of the results
 * @param reading how the recordings were read
 */
public record FolderReport(Path folder, RecordingJob.ChainFactory chains, ReadOptions reading) {
  private static final int MAX_PICTURES = 8;
  private static final long PICTURED_US = 1_000_000;

  /**
   * Adds all to a page: the recordings in the order of their names, the failed ones, and lines of
   * text.
   */
  public void addTo(
      ReportPage page, List<BatchItem> items, List<BatchFailure> failures, List<String> summary)
      throws IOException {
    List<BatchItem> done = new ArrayList<>();
    List<Map<?, ?>> results = new ArrayList<>();
    for (BatchItem item : items) {
      Path file = folder.resolve(item.name()).resolve("done.json");
      if (Files.exists(file) && Json.read(file) instanceof Map<?, ?> result) {
        done.add(item);
        results.add(result);
      }
    }
    page.section("Results");
    page.text(summary);
    if (!failures.isEmpty()) {
      page.table(
          List.of("failed", "cause"),
          failures.stream()
              .map(failure -> List.of(failure.item().name(), failure.cause()))
              .toList());
    }
    page.section("Input");
    page.table(
        List.of("", "recording", "format", "sensor", "events", "rows", "warnings", "SHA-256"),
        IntStream.range(0, done.size()).mapToObj(i -> row(i + 1, results.get(i))).toList());
    if (!done.isEmpty()) {
      addChain(page, done, results.stream().allMatch(one -> Tables.CSV.equals(one.get("tables"))));
    }
  }

  private static List<String> row(int number, Map<?, ?> result) {
    long rows =
        ((List<?>) result.get("outputs"))
            .stream().mapToLong(file -> count(((Map<?, ?>) file).get("rows"))).sum();
    return List.of(
        String.valueOf(number),
        String.valueOf(result.get("recording")),
        String.valueOf(result.get("format")),
        String.valueOf(result.get("sensor")),
        Quantities.count(count(((Map<?, ?>) result.get("counters")).get("events_in"))),
        Quantities.count(rows),
        String.join(
            "\n", ((List<?>) result.get("warnings")).stream().map(String::valueOf).toList()),
        String.valueOf(result.get("recordingSha256")).replaceFirst(".{32}", "$0\n"));
  }

  private static long count(Object number) {
    return number instanceof Number value ? value.longValue() : 0;
  }

  private void addChain(ReportPage page, List<BatchItem> done, boolean isText) throws IOException {
    try (RecordingReader first = Recordings.open(done.get(0).recording(), reading);
        FilterChain chain = chains.create(first.geometry())) {
      page.section("Chain");
      page.table(
          ChainTable.HEADER.subList(0, 3),
          ChainTable.rows(chain).stream().map(cells -> cells.subList(0, 3)).toList());
      page.section("Means of each recording");
      if (isText) {
        for (PlotField field : PlotSet.main(PlotField.of(chain))) {
          addMeans(page, field, done);
        }
      } else {
        page.sentence("No command reads Parquet back: a batch with --format csv shows the means.");
      }
      page.section("Pictures of events and results, from the first second");
      for (BatchItem item : done.subList(0, Math.min(MAX_PICTURES, done.size()))) {
        page.text(List.of(item.name()));
        page.picture(pictures(item), item.name() + " at moments of its first second");
      }
      page.folded("The chain as a file", List.of(ChainFile.write(chain).strip()));
    }
  }

  private void addMeans(ReportPage page, PlotField field, List<BatchItem> done) throws IOException {
    double[] numbers = IntStream.rangeClosed(1, done.size()).asDoubleStream().toArray();
    double[] values = new double[done.size()];
    for (int i = 0; i < values.length; i++) {
      String table = field.stage() + "." + field.outlet() + ".csv";
      values[i] = mean(folder.resolve(done.get(i).name()).resolve(table), field.column());
    }
    String unit = field.unit().isEmpty() ? "" : " (" + field.unit() + ")";
    page.plot(
        SvgPlot.around(new double[] {0.5, done.size() + 0.5}, values)
            .wholeX()
            .dots("", ReportPage.colour("", 0), numbers, values)
            .draw(field.title(), "recording", field.label() + unit),
        Map.of(),
        "");
  }

  private Optional<BufferedImage> pictures(BatchItem item) throws IOException {
    try (RecordingReader reader = Recordings.open(item.recording(), reading);
        FilterChain chain = chains.create(reader.geometry())) {
      ContactSheet sheet = new ContactSheet(chain);
      EventRate seen = new EventRate(2);
      EventSource source = RunReport.inShortPackets(reader);
      ChainRunner runner =
          new ChainRunner(chain, new PipelineCounters(), OnFailure.STOP, failure -> {});
      runner.addSink(seen, true);
      runner.addSink(sheet, false);
      while (seen.elapsedUs() < PICTURED_US && source.next(runner)) {
        // up to a second of events
      }
      runner.notified(new EndOfStream(runner.lastUs()));
      return sheet.draw();
    }
  }

  /** Mean of a column of a table, NaN without values. */
  private static double mean(Path table, String column) throws IOException {
    DoubleSummaryStatistics values = new DoubleSummaryStatistics();
    if (Files.exists(table)) {
      try (BufferedReader lines = Files.newBufferedReader(table)) {
        CsvTable cells = new CsvTable(lines, List.of(column));
        while (cells.next()) {
          if (Double.isFinite(cells.number(0))) {
            values.accept(cells.number(0));
          }
        }
      }
    }
    return values.getCount() == 0 ? Double.NaN : values.getAverage();
  }
}
