package haltere.ui.viewer;

import haltere.core.chain.ChainFile;
import haltere.core.chain.FilterChain;
import haltere.core.format.Conversion;
import haltere.core.format.ProgressListener;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.core.playback.Loop;
import haltere.core.playback.Playable;
import haltere.ui.export.FilmWriter;
import haltere.ui.export.GifWriter;
import haltere.ui.export.Mp4Writer;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;

/**
 * Exports the marked part of the recording that is open, or all of it, through the chain: as a film
 * with overlays or as data. Works on a copy of the chain and on its own reader, in the background.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class ExportFeature implements ViewerFeature {
  private static final double FRAMES_PER_SECOND = 25;

  /** A recording, and what of it is wanted. */
  private record Part(Path file, long fromUs, long toUs) {}

  private ViewerContext window;

  @Override
  public void install(ViewerContext installed) {
    window = installed;
    FileDialogs dialogs = window.dialogs();
    window
        .actions()
        .add(
            ViewerAction.of(
                    "export-film",
                    "Export the marked part as film\u2026",
                    "File",
                    () -> part().ifPresent(part -> dialogs.film().ifPresent(this::exportFilm)))
                .withHelp("GIF or MP4, with overlays, at the speed of playback."),
            ViewerAction.of(
                    "export-data",
                    "Export the marked part as recording\u2026",
                    "File",
                    () ->
                        part()
                            .ifPresent(
                                part -> dialogs.recordingToExport().ifPresent(this::exportData)))
                .withHelp("What the chain leaves of the events, in any format that is written."));
  }

  /** What is marked; says what is lacking if nothing can be exported. */
  private Optional<Part> part() {
    Optional<ViewerSession> session = window.sessions().session();
    if (session.isEmpty() || session.get().file().isEmpty()) {
      window.status().showError("Only a recording can be exported; record it first (Ctrl+E)");
      return Optional.empty();
    }
    Loop loop = window.playback().loopProperty().get();
    long durationUs = session.get().player().status().durationUs();
    return Optional.of(
        new Part(
            session.get().file().get(),
            loop.inUs().orElse(0),
            Math.min(durationUs, loop.outUs().orElse(durationUs))));
  }

  /** Writes a film; its name's ending says in which format. */
  void exportFilm(Path file) {
    double speed = window.playback().speedProperty().get();
    double pictureUs = (Double.isInfinite(speed) ? 1 : speed) * 1e6 / FRAMES_PER_SECOND;
    DisplayOptions options = window.display().options();
    part()
        .ifPresent(
            part ->
                withChain(
                    file,
                    json ->
                        () -> {
                          try (Playable playable =
                                  Sources.recording(part.file(), ReadOptions.DEFAULT);
                              FilmWriter film = film(file)) {
                            FilterChain chain = Sources.chain(playable.geometry(), json);
                            try {
                              long pictures =
                                  new ClipExport(
                                          playable,
                                          chain,
                                          options,
                                          film,
                                          part.fromUs(),
                                          part.toUs(),
                                          pictureUs)
                                      .run();
                              return pictures + " pictures";
                            } finally {
                              chain.close();
                            }
                          }
                        }));
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
  void exportData(Path file) {
    part()
        .ifPresent(
            part ->
                withChain(
                    file,
                    json ->
                        () -> {
                          try (RecordingReader reader =
                                  Recordings.open(
                                      part.file(), ReadOptions.DEFAULT.withReadings(true));
                              Playable clock =
                                  Sources.recording(part.file(), ReadOptions.DEFAULT)) {
                            return data(file, part, json, reader, clock);
                          }
                        }));
  }

  private static String data(
      Path file, Part part, String json, RecordingReader reader, Playable clock)
      throws IOException {
    FilterChain chain = Sources.chain(reader.geometry(), json);
    long startUs = -clock.elapsedUs(0);
    try (RecordingWriter writer =
        Recordings.forWriting(file)
            .create(file, WriteOptions.of(reader.geometry()).withOverwrite(true))
            .orElseThrow(() -> new IOException(file + ": this format is only read"))) {
      Conversion conversion =
          new Conversion(
              part.fromUs() + startUs,
              part.toUs() + startUs,
              Optional.of(chain),
              ProgressListener.NONE);
      return Texts.count(conversion.run(reader, writer).eventsWritten()) + " events";
    } finally {
      chain.close();
    }
  }

  /** Takes a copy of the chain, and works with it in the background. */
  private void withChain(Path file, java.util.function.Function<String, Callable<String>> work) {
    window.status().setActivity("Exporting to " + file.getFileName() + " \u2026");
    window
        .editor()
        .read(
            ChainFile::write,
            json ->
                window
                    .background()
                    .export(
                        work.apply(json),
                        done ->
                            window
                                .status()
                                .setActivity("Exported " + file.getFileName() + ": " + done),
                        window.status()::showProblem));
  }
}
