package haltere.ui.command;

import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.pipeline.Pipeline;
import haltere.core.pipeline.PipelineCounters;
import haltere.core.simulation.Scene;
import haltere.core.simulation.Scenes;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.filters.DefaultChain;
import haltere.filters.cluster.ClusterTrack;
import haltere.ui.rendering.ColourMap;
import haltere.ui.rendering.EventFrame;
import haltere.ui.rendering.FramePainter;
import haltere.ui.rendering.Pictures;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.BitSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * What the viewer shows at first, without a window: the built-in fly scene through the default
 * chain, with a picture and a table at the end. The same every time.
 */
final class HeadlessDemo {
  private static final int DURATION_S = 3;
  private static final long FADING_US = 4_000;

  private final Subcommand command;

  HeadlessDemo(Subcommand command) {
    this.command = command;
  }

  /** Runs the scene; files of an earlier run are replaced. */
  int run() throws IOException {
    Path folder = command.surroundings().folder().resolve("build").resolve("demo");
    Files.createDirectories(folder);
    Path picture = folder.resolve("fly.png");
    long startNanos = System.nanoTime();
    try (Scene<?> scene = Scenes.named("fly").create(List.of("run.durationS=" + DURATION_S))) {
      FilterChain chain = DefaultChain.create(scene.geometry());
      LatestSnapshots marks = new LatestSnapshots(chain);
      EventFrame frame = new EventFrame(scene.geometry());
      PipelineCounters counters = new PipelineCounters();
      BitSet clusters = new BitSet();
      chain.outlet("clusters", ClusterTrack.class).subscribe(row -> clusters.set(row.id()));
      Map<Path, Long> rows;
      try (OutletTables tables =
              OutletTables.open(
                  chain, (stage, outlet) -> folder.resolve(outlet.name() + ".csv"), true);
          ProgressBar bar = command.progressBar("fly scene")) {
        Pipeline.run(scene, chain, List.of(frame, new Progress(bar, scene, counters)), counters);
        double seconds = (System.nanoTime() - startNanos) / 1e9;
        Pictures.write(
            picture,
            Pictures.draw(
                frame,
                new FramePainter(ColourMap.DARK, FADING_US),
                Pictures.usualScale(scene.geometry()),
                marks));
        tables.finish();
        rows = tables.rows();
        bar.erase();
        summary(counters, clusters.cardinality(), seconds);
      }
      chain.close();
      command.result("  picture    " + picture);
      rows.forEach(
          (table, count) ->
              command.result("  table      " + table + " (" + Quantities.count(count) + " rows)"));
    }
    return Subcommand.OK;
  }

  private void summary(PipelineCounters counters, int clusters, double seconds) {
    long in = counters.get(PipelineCounters.Counter.EVENTS_IN);
    long out = counters.get(PipelineCounters.Counter.EVENTS_OUT);
    command.result(
        "the built-in fly scene through the default chain, without a display; "
            + "haltere --help says what else there is");
    command.result(
        String.format(
            Locale.ROOT, "  events     %,d in %d s, %,d left by the filters", in, DURATION_S, out));
    command.result("  rate       " + Quantities.rate(in / (double) DURATION_S));
    command.result("  clusters   " + clusters);
    command.result(
        String.format(
            Locale.ROOT,
            "  speed      %s, %.1f times real time",
            Quantities.rate(in / seconds),
            DURATION_S / seconds));
  }

  /** Moves the bar. */
  private record Progress(ProgressBar bar, Scene<?> scene, PipelineCounters counters)
      implements StreamHandler {
    @Override
    public void packet(EventPacket packet) {
      if (!packet.isEmpty()) {
        bar.events(counters.get(PipelineCounters.Counter.EVENTS_IN));
        bar.progress(packet.lastTimeUs() - scene.startUs(), DURATION_S * 1_000_000L);
      }
    }

    @Override
    public void notified(StreamNotification notification) {
      // nothing to show of it
    }
  }
}
