package haltere.ui.command;

import haltere.core.batch.Batch;
import haltere.core.batch.BatchFailure;
import haltere.core.batch.BatchInputs;
import haltere.core.batch.BatchItem;
import haltere.core.batch.BatchOptions;
import haltere.core.batch.BatchOptions.Existing;
import haltere.core.batch.BatchReport;
import haltere.core.chain.ChainFile;
import haltere.core.chain.FilterChain;
import haltere.core.chain.Filters;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.sink.Tables;
import haltere.ui.command.report.FolderReport;
import haltere.ui.command.report.ReportPage;
import haltere.ui.command.terminal.ProgressBar;
import haltere.ui.command.terminal.Quantities;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Runs one chain over many recordings. */
@Command(
    name = "batch",
    footer = {"", "Example: haltere batch recordings --track --out results --report results.html"},
    description = {
      "Run one chain over many recordings, several at once.",
      "DIR gets a folder for each recording, with a table for each outlet of the "
          + "chain (STAGE.OUTLET.csv or .parquet). done.json comes last, with input, "
          + "chain and checksums. A failed recording does not stop the batch: "
          + "failed.json lists the failures, and the status is 1."
    })
final class BatchCommand extends Subcommand {
  private static final Pattern SHARD = Pattern.compile("(\\d{1,6})/(\\d{1,6})");

  /** Those of the wing tracker without a row for each event. */
  private static final Set<String> WING_OUTLETS =
      Set.of(
          "estimates wings averages differences variances beats pairs geometry initialisation"
              .split(" "));

  @Parameters(
      arity = "0..*",
      paramLabel = "INPUT",
      description = "Recordings, and folders, which are searched recursively.")
  List<Path> inputs = List.of();

  @Option(
      names = "--list",
      paramLabel = "FILE",
      description = "A text file with an INPUT in each line. May be repeated.")
  List<Path> lists = List.of();

  @Option(
      names = "--root",
      paramLabel = "FOLDER",
      description =
          "Base folder for the names of results; default: each INPUT folder, and for "
              + "an INPUT recording its own name.")
  Path root;

  static final class WorkOptions {
    @Option(
        names = "--chain",
        paramLabel = "CHAIN.json",
        description = "A chain of filters, saved by the viewer or written by hand.")
    Path chain;

    @Option(names = "--wings", description = "The wing tracker with its defaults.")
    boolean wings;

    @Option(names = "--track", description = "The object tracker with its defaults.")
    boolean track;
  }

  @ArgGroup(multiplicity = "1", exclusive = true)
  WorkOptions work;

  @Option(
      names = "--out",
      required = true,
      paramLabel = "DIR",
      description = "Output folder; created if missing.")
  Path out;

  @Option(
      names = "--workers",
      paramLabel = "N",
      description = "Number of concurrent recordings; default: one for each processor.")
  Integer workers;

  @Option(
      names = "--shard",
      paramLabel = "I/N",
      defaultValue = "1/1",
      description =
          "Process one of N parts of the inputs, 1/N to N/N. The names of the "
              + "recordings alone decide, so N machines share the work without a coordinator.")
  String shard;

  @Option(
      names = "--format",
      paramLabel = "csv|parquet",
      defaultValue = Tables.CSV,
      description = "Format of the tables: csv (the default) or parquet.")
  String format;

  @Option(
      names = "--outlets",
      split = ",",
      paramLabel = "NAME",
      description =
          "Outlets that get a table, such as wings,beats. Default: all, but with "
              + "--wings not measurements, which has a row for each event.")
  Set<String> outlets;

  @Option(
      names = "--resume",
      description =
          "Keep complete results of the same chain, version, options and recording; "
              + "compute the others.")
  boolean resume;

  @Option(names = "--overwrite", description = "Compute all results again.")
  boolean overwrite;

  @Mixin SourceOptions source;
  @Mixin ReportOptions reporting;

  @Override
  public Integer call() throws IOException {
    check();
    Shard part = part();
    BatchInputs found = inputs();
    Collection<BatchItem> items =
        found.items().stream().filter(item -> item.shard(part.of) == part.number).toList();
    if (found.items().isEmpty()) {
      throw new CommandProblem("the inputs contain no recording; " + out + " is not searched");
    }
    if (found.leftOut() > 0) {
      message("not read, no recording: " + Quantities.counted(found.leftOut(), "file"));
    }
    Batch batch = new Batch(this::chain, options(), Failures::describe);
    BatchReport report = run(batch, items, part.failuresName());
    String summary =
        Quantities.text(
            "%s: %d done (%s, %.1f MB, %s), %d kept, %d in progress elsewhere, %d failed",
            Quantities.counted(items.size(), "recording"),
            report.done(),
            Quantities.events(report.events()),
            report.bytes() / 1e6,
            Quantities.counted(report.rows(), "row"),
            report.kept(),
            report.elsewhere(),
            report.failures().size());
    result(summary);
    if (reporting.report != null) {
      ReportPage page = reporting.page(out);
      new FolderReport(out, this::chain, options().reading())
          .addTo(
              page,
              items.stream().sorted(Comparator.comparing(BatchItem::name)).toList(),
              report.failures(),
              List.of(summary));
      reporting.write(page, overwrite || resume);
    }
    return report.failures().isEmpty() ? OK : FAILED;
  }

  private BatchReport run(Batch batch, Collection<BatchItem> items, String failures)
      throws IOException {
    try (ProgressBar bar = progressBar("batch")) {
      return batch.run(
          items,
          failures,
          new Batch.Listener() {
            @Override
            public void progress(long doneBytes, long totalBytes) {
              bar.progress(doneBytes, totalBytes);
            }

            @Override
            public void failed(BatchFailure failure) {
              error(failure.item().name() + ": failed: " + failure.cause());
            }

            @Override
            public void warned(BatchItem item, String warning) {
              warning(item.name() + ": " + warning);
            }
          });
    }
  }

  private void check() throws IOException {
    if (inputs.isEmpty() && lists.isEmpty()) {
      throw wrongArguments("there is no INPUT and no --list");
    }
    if (resume && overwrite) {
      throw wrongArguments("--resume keeps results, and --overwrite replaces them");
    }
    checkRange(
        workers == null || workers >= 1 && workers <= 1024, "--workers", workers, "1 to 1024");
    checkTables("--format", format);
    if (Files.exists(out) && !Files.isDirectory(out)) {
      throw new CommandProblem(out + ": this is a file; name a folder");
    }
    if (reporting.report != null) {
      // a page among the results must not replace one of their files
      checkNeeded(reporting.report.toString().endsWith(".html"), "a name in .html", "--report");
      Files.createDirectories(out); // a report may be in it
      WritingOptions writing = new WritingOptions();
      writing.overwrite = overwrite || resume;
      writing.check(inputs, List.of(reporting.report));
    }
  }

  private BatchOptions options() {
    return new BatchOptions(
        out,
        workers == null ? Runtime.getRuntime().availableProcessors() : workers,
        resume ? Existing.RESUME : overwrite ? Existing.OVERWRITE : Existing.REFUSE,
        source.apply(ReadOptions.DEFAULT),
        source.strict,
        new Version().getVersion()[0],
        format,
        outlets != null ? outlets : work.wings ? WING_OUTLETS : Set.of());
  }

  private BatchInputs inputs() throws IOException {
    BatchInputs found = new BatchInputs(out, Optional.ofNullable(root));
    for (Path input : inputs) {
      found.add(input);
    }
    for (Path list : lists) {
      found.addList(list);
    }
    return found;
  }

  private FilterChain chain(SensorGeometry geometry) throws IOException {
    if (work.chain == null) {
      FilterChain chain = new FilterChain(geometry);
      chain.add(Filters.named(work.wings ? "wing-tracker" : "object-tracker"));
      return chain;
    }
    return ChainFile.read(work.chain, geometry, this::note);
  }

  private final Set<String> notes = new HashSet<>();

  /** Prints a note on the chain once, not for each recording. */
  private synchronized void note(String text) {
    if (notes.add(text)) {
      warning(text);
    }
  }

  /** Which part of the inputs is worked on. */
  private record Shard(int number, int of) {
    String failuresName() {
      return of == 1 ? "failed.json" : "failed-" + number + "-of-" + of + ".json";
    }
  }

  private Shard part() {
    Matcher matcher = SHARD.matcher(shard);
    if (matcher.matches()) {
      Shard part =
          new Shard(Integer.parseInt(matcher.group(1)), Integer.parseInt(matcher.group(2)));
      if (part.number >= 1 && part.number <= part.of) {
        return part;
      }
    }
    throw wrongArguments("--shard is " + shard + "; it is I/N with I from 1 to N, such as 1/4");
  }
}
