package haltere.ui.viewer.session;

import haltere.core.chain.ChainFile;
import haltere.core.chain.FilterChain;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.playback.KeptPlayable;
import haltere.core.playback.Playable;
import haltere.core.playback.PlayerOptions;
import haltere.core.playback.RecordingPlayable;
import haltere.core.playback.ScenePlayable;
import haltere.core.simulation.Scenes;
import haltere.ui.viewer.picture.DisplayOptions;
import haltere.ui.viewer.playback.PlaybackController;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;

/**
 * What is to be opened, and how a session of it is made.
 *
 * <p>Thread rule: may be made on any thread; sessions are made in the background, because files are
 * read.
 *
 * @param playable opens it
 * @param file where it is, if it is a file
 * @param options what the user says about the file
 * @param name what a person would call it
 * @param start the filters and plots that it begins with where none are open
 */
public record SessionRequest(
    Callable<Playable> playable,
    Optional<Path> file,
    ReadOptions options,
    String name,
    FirstView start) {
  /** Events of a camera or a scene that are kept, in 48 MB. */
  private static final int KEPT_EVENTS = 6_000_000;

  /** A recording. */
  public static SessionRequest recording(Path file, ReadOptions options) {
    return new SessionRequest(
        () -> play(file, options), Optional.of(file), options, file.toString(), FirstView.RAW);
  }

  /** The built-in scene. */
  public static SessionRequest scene() {
    return scene("fly", "Fly scene");
  }

  /**
   * A simulated scene by its name on the command line, such as {@code road}, with its default
   * settings and the title that a person calls it.
   */
  public static SessionRequest scene(String scene, String title) {
    return new SessionRequest(
        () -> new ScenePlayable(() -> Scenes.named(scene).create(List.of()), title),
        Optional.empty(),
        ReadOptions.DEFAULT,
        scene.equals("fly") ? "the fly scene" : title,
        scene.endsWith("fly") ? FirstView.FLY : FirstView.OBJECTS);
  }

  /** What is not a file, under the name that a person would call it. */
  public static SessionRequest made(Callable<Playable> playable, String name) {
    return new SessionRequest(playable, Optional.empty(), ReadOptions.DEFAULT, name, FirstView.RAW);
  }

  /** A recording, or the built-in scene where there is no file. */
  public static SessionRequest of(Optional<Path> file, ReadOptions options) {
    return file.map(path -> recording(path, options)).orElseGet(SessionRequest::scene);
  }

  /** A recording to be played; one that cannot be read is told in one line for a person. */
  public static Playable play(Path file, ReadOptions options) throws IOException {
    RecordingReader reader = Recordings.open(file, options.withSamples(true));
    try {
      return new RecordingPlayable(reader);
    } catch (IOException | RuntimeException problem) {
      reader.close();
      throw problem;
    }
  }

  /** What a chain of its own is kept under: the file's whole path, or the name. */
  public String chainKey() {
    return file.map(path -> path.toAbsolutePath().normalize().toString()).orElse(name);
  }

  /**
   * Makes a session; background thread. A saved chain of its own that does not fit, or lacks a
   * filter that a scene is shown with, is not used.
   */
  public ViewerSession session(
      Optional<String> chainJson, PlayerOptions playerOptions, DisplayOptions displayOptions)
      throws Exception {
    Playable opened =
        file.isPresent() ? playable.call() : new KeptPlayable(playable.call(), KEPT_EVENTS);
    try {
      FilterChain chain =
          chainJson
              .flatMap(json -> ownChain(opened.geometry(), json))
              .filter(start::isCoveredBy)
              .orElseGet(() -> start.chain(opened.geometry()));
      return ViewerSession.of(opened, this, chain, playerOptions, displayOptions);
    } catch (RuntimeException problem) {
      opened.close();
      throw problem;
    }
  }

  /** A chain that was kept for a recording or a scene; empty where it does not fit any more. */
  private static Optional<FilterChain> ownChain(SensorGeometry geometry, String json) {
    try {
      return Optional.of(ChainFile.parse(json, "the chain", geometry));
    } catch (IOException | RuntimeException unfit) {
      return Optional.empty();
    }
  }

  /**
   * Makes the {@link #session} that a new window shows, and has its player paint the first slice,
   * so that there are events to show as soon as there is a window. Background thread.
   */
  public ViewerSession firstSession(Optional<String> chainJson) throws Exception {
    PlayerOptions paused = PlaybackController.firstOptions().withPaused(true);
    return session(chainJson, paused, DisplayOptions.DEFAULT).prepared();
  }
}
