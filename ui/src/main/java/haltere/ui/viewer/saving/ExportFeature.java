package haltere.ui.viewer.saving;

import haltere.core.chain.ChainFile;
import haltere.core.chain.FilterChain;
import haltere.core.playback.BufferedPlayable;
import haltere.core.playback.Loop;
import haltere.core.playback.Playable;
import haltere.core.playback.PlayerStatus;
import haltere.ui.viewer.action.ViewerActions;
import haltere.ui.viewer.controls.FileDialogs;
import haltere.ui.viewer.feature.StatusLine;
import haltere.ui.viewer.feature.WindowFeature;
import haltere.ui.viewer.picture.DisplayOptions;
import haltere.ui.viewer.picture.Overlays;
import haltere.ui.viewer.session.ViewerSession;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import java.util.concurrent.Future;
import java.util.function.LongConsumer;
import javafx.application.Platform;

/**
 * Exports the marked part, or all, through the chain: as a film with overlays or as data. Works in
 * the background on a copy of the chain, with a second reader of a recording, or a copy of the
 * buffered interval of a camera or a scene.
 */
public final class ExportFeature extends WindowFeature {
  private static final long BETWEEN_NANOS = 250_000_000;
  private static final String EXPORTING = "Exporting to %s \u2026 ";

  /** A request, on the elapsed timeline of the playable of {@code open}. */
  private record Wanted(
      Callable<Playable> open, String chain, long startUs, long fromUs, long toUs, long sliceUs) {
    PartExport.ExportedPart part(Playable opened, FilterChain parsed) {
      return new PartExport.ExportedPart(opened, parsed, startUs, fromUs, toUs, sliceUs);
    }
  }

  /** Begins to export a part. */
  private interface Exporter {
    /** In the background. */
    PartExport begin(PartExport.ExportedPart part) throws IOException;
  }

  private final List<Future<?>> running = new ArrayList<>();
  private volatile int stops;

  @Override
  protected void install() {
    FileDialogs dialogs = window.dialogs();
    ViewerActions actions = window.actions();
    actions.add(
        "export-film",
        () ->
            dialogs
                .save("Export film", "film.gif", "Films", "*.gif", "*.mp4")
                .ifPresent(this::exportFilm),
        window::nothingOpen);
    actions.add(
        "export-data",
        () -> dialogs.newRecording().ifPresent(this::exportData),
        window::nothingOpen);
    actions.add(
        "stop-export",
        this::stop,
        () -> running.stream().allMatch(Future::isDone) ? "nothing is being exported" : "");
  }

  /** Stops running and waiting exports and removes their files. */
  public void stop() {
    stops++;
    running.forEach(export -> export.cancel(true));
    window.status().setActivity("Exports were stopped");
    running.clear();
  }

  /** Exports a film; the file name gives the format. */
  public void exportFilm(Path file) {
    double speed = window.playback().speedProperty().get();
    double filmSpeed = Double.isInfinite(speed) ? 1 : speed;
    long sliceUs = window.playback().status().map(PlayerStatus::sliceUs).orElse(0L);
    DisplayOptions options = window.display().options().forSlices(sliceUs);
    Overlays overlays = window.display().overlays();
    export(file, part -> new ClipExport(part, file, options, overlays, filmSpeed));
  }

  /** Exports the events that the chain passes; the file name gives the format. */
  public void exportData(Path file) {
    export(file, part -> new DataExport(part, file));
  }

  private void export(Path file, Exporter exporter) {
    window.ifOpen(open -> export(open, file, exporter));
  }

  private void export(ViewerSession open, Path file, Exporter exporter) {
    String name = file.getFileName().toString();
    Exporter checked =
        part -> {
          open.request().checkOther(file);
          return exporter.begin(part);
        };
    StatusLine status = window.status();
    // an earlier problem would hide the progress
    status.clearError();
    status.setActivity(EXPORTING.formatted(name));
    Loop loop = window.playback().loopProperty().get();
    window
        .editor()
        .read(
            chain -> wanted(open, loop, chain),
            wanted -> begin(name, wanted, checked),
            problem -> status.showError(name + " was not exported: " + problem));
  }

  private void begin(String name, Wanted wanted, Exporter exporter) {
    running.removeIf(Future::isDone);
    int stopsBefore = stops;
    running.add(
        window
            .background()
            .export(
                () -> export(wanted, exporter, progress(name, wanted, stopsBefore)),
                done -> window.status().setActivity("Exported " + name + ": " + done),
                problem -> {
                  if (stops == stopsBefore) {
                    window.status().showProblem(problem);
                  }
                }));
  }

  /** Shows the progress of an export, a few times a second, unless exports are stopped. */
  private LongConsumer progress(String name, Wanted wanted, int stopsBefore) {
    long[] reportedNanos = {System.nanoTime()};
    return elapsedUs -> {
      if (stops != stopsBefore) {
        // reading a font clears the interrupt of its thread
        throw new CancellationException();
      }
      long now = System.nanoTime();
      if (now - reportedNanos[0] >= BETWEEN_NANOS) {
        reportedNanos[0] = now;
        double share = (elapsedUs - wanted.fromUs()) / (double) (wanted.toUs() - wanted.fromUs());
        int percent = (int) (100 * Math.max(0, Math.min(1, share)));
        Platform.runLater(
            () -> {
              if (stops == stopsBefore) {
                window.status().setActivity(EXPORTING.formatted(name) + percent + " %");
              }
            });
      }
    };
  }

  /** The marked part, or all without one; processing thread. */
  private static Wanted wanted(ViewerSession open, Loop loop, FilterChain chain) {
    String json = ChainFile.write(chain);
    Playable playing = open.player().playable();
    long fromUs = Math.max(playing.earliestUs(), loop.inUs().orElse(0));
    long endUs = playing.durationUs().orElseGet(() -> playing.nearestUs(Long.MAX_VALUE));
    long toUs = Math.min(endUs, loop.outUs().orElse(Long.MAX_VALUE));
    long sliceUs = open.player().status().sliceUs();
    long runUpUs = Math.max(chain.memoryUs(), open.display().memoryUs(sliceUs));
    long startUs = Math.max(0, fromUs - runUpUs);
    if (playing instanceof BufferedPlayable kept) {
      Playable copy = kept.copy(startUs, toUs);
      return new Wanted(() -> copy, json, startUs, fromUs, toUs, sliceUs);
    }
    return new Wanted(open.request().playable(), json, startUs, fromUs, toUs, sliceUs);
  }

  private static String export(Wanted wanted, Exporter exporter, LongConsumer progress)
      throws Exception {
    try (Playable playable = wanted.open().call();
        FilterChain chain = ChainFile.parse(wanted.chain(), "the chain", playable.geometry());
        PartExport export = exporter.begin(wanted.part(playable, chain))) {
      return export.run(progress);
    }
  }
}
