package haltere.ui.command;

import haltere.core.chain.FilterChain;
import haltere.core.pipeline.Pipeline;
import haltere.core.pipeline.PipelineCounters;
import haltere.core.simulation.Scene;
import haltere.core.simulation.Scenes;
import haltere.core.sink.CsvSink;
import haltere.core.stream.StreamHandler;
import haltere.filters.DefaultChain;
import haltere.filters.wing.WingEstimate;
import haltere.filters.wing.tracker.WingTrackerFilter;
import haltere.ui.command.results.WingsSummary;
import haltere.ui.command.terminal.ProgressBar;
import haltere.ui.command.terminal.Quantities;
import haltere.ui.rendering.ColourMap;
import haltere.ui.rendering.EventFrame;
import haltere.ui.rendering.FramePainter;
import haltere.ui.rendering.OverlaySnapshots;
import haltere.ui.rendering.Pictures;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/**
 * The start view of the viewer without a window: the built-in fly scene through the chain for a
 * fly, with a picture and a table of the wings. Results are reproducible.
 *
 * @param command prints the results
 */
record HeadlessDemo(Subcommand command) {
  private static final int DURATION_S = 3;
  private static final long FADING_US = 4_000;

  /** Runs the scene; files of an earlier run are replaced. */
  int run() throws IOException {
    Path folder = command.surroundings().folder().resolve("build").resolve("demo");
    Files.createDirectories(folder);
    Path picture = folder.resolve("fly.png");
    Path table = folder.resolve("wings.csv");
    long startNanos = System.nanoTime();
    try (Scene<?> scene = Scenes.named("fly").create(List.of("run.durationS=" + DURATION_S))) {
      FilterChain chain = DefaultChain.forFly(scene.geometry());
      WingTrackerFilter wings = (WingTrackerFilter) chain.stage("wing-tracker").filter();
      OverlaySnapshots marks = new OverlaySnapshots(chain);
      EventFrame frame = new EventFrame(scene.geometry());
      PipelineCounters counters = new PipelineCounters();
      WingsSummary summary = new WingsSummary(wings, wings.settings().output().rateHz());
      summary.listenTo(chain);
      long rows;
      try (CsvSink<WingEstimate> estimates = CsvSink.create(table, WingEstimate.class, true);
          ProgressBar bar = command.progressBar("fly scene")) {
        chain.outlet("wings", WingEstimate.class).subscribe(estimates);
        StreamHandler progress =
            packet -> {
              if (!packet.isEmpty()) {
                bar.events(counters.get(PipelineCounters.Counter.EVENTS_IN));
                bar.progress(packet.lastTimeUs() - scene.startUs(), DURATION_S * 1_000_000L);
              }
            };
        Pipeline.run(scene, chain, List.of(frame, progress, summary), counters);
        double seconds = (System.nanoTime() - startNanos) / 1e9;
        Pictures.write(
            picture,
            Pictures.draw(
                frame,
                new FramePainter(ColourMap.DARK, FADING_US),
                Pictures.defaultScale(scene.geometry()),
                canvas -> marks.marks().forEach(layer -> layer.draw(frame.nowUs(), canvas))));
        estimates.finish();
        rows = estimates.rows();
        bar.erase();
        say(counters, summary, seconds);
      }
      chain.close();
      command.result("  picture    " + picture);
      command.result("  table      " + table + " (" + Quantities.counted(rows, "row") + ")");
    }
    return Subcommand.OK;
  }

  private void say(PipelineCounters counters, WingsSummary wings, double seconds) {
    long in = counters.get(PipelineCounters.Counter.EVENTS_IN);
    long out = counters.get(PipelineCounters.Counter.EVENTS_OUT);
    command.result(
        "the built-in fly scene through the wing tracker's chain, without a display; "
            + "see haltere --help for more");
    command.result("  events     %,d in %d s, %,d passed by the filters", in, DURATION_S, out);
    command.result("  rate       " + Quantities.rate(in / (double) DURATION_S));
    wings.lines().forEach(line -> command.result("  " + line));
    command.result(
        "  speed      %s, %.1f times real time",
        Quantities.rate(in / seconds), DURATION_S / seconds);
  }
}
