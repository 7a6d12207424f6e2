package haltere.ui.viewer.saving;

import haltere.core.chain.ChainFile;
import haltere.core.chain.FilterChain;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.core.playback.KeptPlayable;
import haltere.core.playback.Loop;
import haltere.core.playback.Playable;
import haltere.ui.export.FilmWriter;
import haltere.ui.export.GifWriter;
import haltere.ui.export.Mp4Writer;
import haltere.ui.viewer.action.ViewerActions;
import haltere.ui.viewer.controls.FileDialogs;
import haltere.ui.viewer.controls.Texts;
import haltere.ui.viewer.feature.StatusLine;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;
import haltere.ui.viewer.picture.DisplayOptions;
import haltere.ui.viewer.picture.Overlays;
import haltere.ui.viewer.session.SessionRequest;
import haltere.ui.viewer.session.ViewerSession;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.Future;
import java.util.function.LongConsumer;
import javafx.application.Platform;

/**
 * Exports the marked part of what is open, or all of it, through the chain: as a film with overlays
 * or as data. Works in the background, on a copy of the chain; a recording is read anew, of a
 * camera and a scene the moments that are kept are copied.
 *
 * <p>Thread rule: JavaFX thread only.
 */
public final class ExportFeature implements ViewerFeature {
  private static final double FRAMES_PER_SECOND = 25;

  /** What is wanted, on the elapsed timeline of what {@code open} gives. */
  private record Part(Callable<Playable> open, String chain, long fromUs, long toUs) {}

  /** Exports a part. */
  private interface Exporter {
    /** In the background; says what was done. */
    String export(Part part, Playable playable, FilterChain chain, LongConsumer progress)
        throws IOException;
  }

  /** Says how far an export is, a few times a second. */
  private final class Progress implements LongConsumer {
    private static final long BETWEEN_NANOS = 250_000_000;

    private final String name;
    private final Part part;
    private final int stopsBefore;
    private long saidNanos = System.nanoTime();

    Progress(String name, Part part, int stopsBefore) {
      this.name = name;
      this.part = part;
      this.stopsBefore = stopsBefore;
    }

    @Override
    public void accept(long elapsedUs) {
      long now = System.nanoTime();
      if (now - saidNanos < BETWEEN_NANOS) {
        return;
      }
      saidNanos = now;
      double share = (elapsedUs - part.fromUs()) / (double) (part.toUs() - part.fromUs());
      int percent = (int) (100 * Math.max(0, Math.min(1, share)));
      Platform.runLater(
          () -> {
            if (stops == stopsBefore) {
              window.status().setActivity(exporting(name) + percent + " %");
            }
          });
    }
  }

  private ViewerContext window;
  private final List<Future<?>> running = new ArrayList<>();
  private int stops;

  @Override
  public void install(ViewerContext installed) {
    window = installed;
    FileDialogs dialogs = window.dialogs();
    ViewerActions actions = window.actions();
    actions.add(
        "export-film",
        () ->
            dialogs
                .save("Export film", "haltere.gif", "Films", "*.gif", "*.mp4")
                .ifPresent(this::exportFilm));
    actions.add(
        "export-data",
        () ->
            dialogs
                .save("Export recording", "part.aedat4", "All files", "*")
                .ifPresent(this::exportData));
    actions.add("stop-export", this::stop);
  }

  private static String exporting(String name) {
    return "Exporting to " + name + " \u2026 ";
  }

  /** Ends what is being exported and what waits for it; nothing of it is kept. */
  void stop() {
    if (running.stream().anyMatch(export -> !export.isDone())) {
      stops++;
      running.forEach(export -> export.cancel(true));
      window.status().setActivity("Exports were stopped");
    }
    running.clear();
  }

  /** Writes a film; its name's ending says in which format. */
  public void exportFilm(Path file) {
    double speed = window.playback().speedProperty().get();
    double pictureUs = (Double.isInfinite(speed) ? 1 : speed) * 1e6 / FRAMES_PER_SECOND;
    DisplayOptions options = window.display().options();
    Overlays overlays = window.display().overlays();
    export(
        file,
        (part, playable, chain, progress) -> {
          try (FilmWriter film = film(file)) {
            ClipExport clip =
                new ClipExport(
                    playable,
                    chain,
                    options,
                    overlays,
                    film,
                    part.fromUs(),
                    part.toUs(),
                    pictureUs);
            long pictures = clip.run(progress);
            return pictures + (pictures == 1 ? " picture" : " pictures");
          }
        });
  }

  private static FilmWriter film(Path file) throws IOException {
    String name = file.getFileName().toString().toLowerCase(Locale.ROOT);
    if (name.endsWith(".gif")) {
      return new GifWriter(file, FRAMES_PER_SECOND);
    }
    if (name.endsWith(".mp4")) {
      return new Mp4Writer(file, FRAMES_PER_SECOND);
    }
    throw new IOException(file.getFileName() + ": a film's name ends in .gif or .mp4");
  }

  /** Writes what the chain leaves of the events; the name's ending says in which format. */
  public void exportData(Path file) {
    export(
        file,
        (part, playable, chain, progress) -> {
          try (RecordingWriter writer =
              Recordings.forWriting(file)
                  .create(file, WriteOptions.of(playable.geometry()).withOverwrite(true))
                  .orElseThrow(() -> new IOException(file + ": this format is only read"))) {
            DataExport export = new DataExport(playable, chain, writer, part.fromUs(), part.toUs());
            return Texts.count(export.run(progress)) + " events";
          }
        });
  }

  private void export(Path file, Exporter exporter) {
    Optional<ViewerSession> session = window.sessions().session();
    if (session.isEmpty()) {
      return;
    }
    StatusLine status = window.status();
    String name = file.getFileName().toString();
    // an older problem would hide how far it is
    status.clearError();
    status.setActivity(exporting(name));
    Loop loop = window.playback().loopProperty().get();
    window
        .editor()
        .read(
            chain -> part(session.get(), loop, chain),
            part -> begin(name, part, exporter),
            problem -> status.showError(name + " was not exported: " + problem));
  }

  private void begin(String name, Part part, Exporter exporter) {
    StatusLine status = window.status();
    running.removeIf(Future::isDone);
    int stopsBefore = stops;
    running.add(
        window
            .background()
            .export(
                () -> export(part, exporter, new Progress(name, part, stopsBefore)),
                done -> status.setActivity("Exported " + name + ": " + done),
                problem -> {
                  if (stops == stopsBefore) {
                    status.showProblem(problem);
                  }
                }));
  }

  /** What is marked, all where nothing is; processing thread. */
  private static Part part(ViewerSession session, Loop loop, FilterChain chain) {
    String json = ChainFile.write(chain);
    Playable playing = session.player().playable();
    long fromUs = Math.max(playing.earliestUs(), loop.inUs().orElse(0));
    long endUs = playing.durationUs().orElseGet(() -> playing.nearestUs(Long.MAX_VALUE));
    long toUs = Math.min(endUs, loop.outUs().orElse(Long.MAX_VALUE));
    if (playing instanceof KeptPlayable kept) {
      Playable copy = kept.copy(fromUs, toUs);
      return new Part(() -> copy, json, fromUs, toUs);
    }
    Path recording = session.file().orElseThrow();
    ReadOptions options = session.options().withSamples(true);
    return new Part(() -> SessionRequest.play(recording, options), json, fromUs, toUs);
  }

  private static String export(Part part, Exporter exporter, LongConsumer progress)
      throws Exception {
    try (Playable playable = part.open().call()) {
      FilterChain chain = ChainFile.parse(part.chain(), "the chain", playable.geometry());
      try {
        return exporter.export(part, playable, chain, progress);
      } finally {
        chain.close();
      }
    }
  }
}
