package haltere.ui.command;

import haltere.core.chain.Outlet;
import haltere.core.format.AtomicFile;
import haltere.core.pipeline.JobReport;
import haltere.core.pipeline.RecordingJob;
import haltere.core.pipeline.internal.Checksums;
import haltere.ui.command.report.ReportPage;
import haltere.ui.command.report.RunReport;
import haltere.ui.plot.PlotField;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import picocli.CommandLine.Option;

/** The option of commands that write a report. */
final class ReportOptions extends OptionGroup {
  @Option(
      names = "--report",
      paramLabel = "REPORT.html",
      description =
          "Write one page with plots, pictures, settings, version and the command, "
              + "without network or scripts.")
  Path report;

  private RunReport gathered;

  /** The same job, observed if a report is requested. */
  RecordingJob watching(RecordingJob job) {
    if (report == null) {
      return job;
    }
    gathered = new RunReport();
    return gathered.watching(job);
  }

  /** Plots columns of results that no filter of the chain publishes, if a report is requested. */
  void plot(Outlet<?> results, String... columns) {
    if (gathered != null) {
      Stream.of(columns)
          .forEach(column -> gathered.plot(new PlotField("", results.name(), column), results));
    }
  }

  /** Writes the report of an observed job, if one is requested. */
  void write(JobReport job, List<String> summary, boolean overwrite) throws IOException {
    if (report != null) {
      ReportPage page = page(job.recording());
      gathered.addTo(page, job, checksum(job.recording()), summary);
      write(page, overwrite);
    }
  }

  /** A page about a file or a folder. */
  ReportPage page(Path about) {
    return new ReportPage("haltere " + command.name() + ": " + about.getFileName());
  }

  static String checksum(Path file) throws IOException {
    return ReadingOptions.isStandard(file) ? "of standard input, not known" : Checksums.of(file);
  }

  /** Writes a page that ends with the version and the command. */
  void write(ReportPage page, boolean overwrite) throws IOException {
    String text =
        command.root().commandLine().getParseResult().originalArgs().stream()
            .map(ReportOptions::quoted)
            .collect(Collectors.joining(" ", "haltere ", ""));
    page.addCommand(new Version().getVersion()[0], text);
    AtomicFile.write(report, page.html(), overwrite);
    subcommand().message("wrote " + report);
  }

  /** A word as a shell reads it back. */
  private static String quoted(String word) {
    return word.matches("[\\w@%+=:,./-]+") ? word : "'" + word.replace("'", "'\\''") + "'";
  }
}
