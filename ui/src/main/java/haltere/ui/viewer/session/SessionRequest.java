package haltere.ui.viewer.session;

import haltere.core.chain.ChainFile;
import haltere.core.chain.FilterChain;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.format.internal.SameFile;
import haltere.core.playback.BufferedPlayable;
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
 * A request to open a source, which creates its session.
 *
 * <p>Thread rule: may be made on any thread; sessions are made in the background, because files are
 * read.
 *
 * @param playable opens it
 * @param file where it is, if it is a file
 * @param options the user's statements about the file
 * @param name display name
 * @param start default filters and plots
 */
public record SessionRequest(
    Callable<Playable> playable,
    Optional<Path> file,
    ReadOptions options,
    String name,
    InitialView start) {
  /** Buffered events of a camera or a scene, 48 MB. */
  private static final int BUFFERED_EVENTS = 6_000_000;

  /** A recording. */
  public static SessionRequest recording(Path file, ReadOptions options) {
    return new SessionRequest(
        () -> play(file, options), Optional.of(file), options, file.toString(), InitialView.RAW);
  }

  /** The built-in scene. */
  public static SessionRequest scene() {
    return scene("fly", "Fly scene");
  }

  /**
   * A simulated scene by its name on the command line, such as {@code road}, with its default
   * settings and a title.
   */
  public static SessionRequest scene(String scene, String title) {
    return new SessionRequest(
        () -> new ScenePlayable(() -> Scenes.named(scene).create(List.of()), title),
        Optional.empty(),
        ReadOptions.DEFAULT,
        scene.equals("fly") ? "the fly scene" : title,
        scene.endsWith("fly") ? InitialView.FLY : InitialView.OBJECTS);
  }

  /** A source that is not a file, with its display name. */
  public static SessionRequest made(Callable<Playable> playable, String name) {
    return new SessionRequest(
        playable, Optional.empty(), ReadOptions.DEFAULT, name, InitialView.RAW);
  }

  /** A recording, or the built-in scene without a file. */
  public static SessionRequest of(Optional<Path> file, ReadOptions options) {
    return file.map(path -> recording(path, options)).orElseGet(SessionRequest::scene);
  }

  /** A playable recording; the message of a failure is one line for the user. */
  public static Playable play(Path file, ReadOptions options) throws IOException {
    RecordingReader reader = Recordings.open(file, options.withSamples(true));
    try {
      return new RecordingPlayable(reader);
    } catch (IOException | RuntimeException problem) {
      reader.close();
      throw problem;
    }
  }

  /** Refuses to write a file that is read. */
  public void checkOther(Path written) throws IOException {
    if (file.isPresent() && SameFile.is(file.get(), written)) {
      throw new IOException(written.getFileName() + " is open; choose another name");
    }
  }

  /** Key of its saved chain: the file's absolute path, or the name. */
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
        file.isPresent() ? playable.call() : new BufferedPlayable(playable.call(), BUFFERED_EVENTS);
    try {
      FilterChain chain =
          chainJson
              .flatMap(json -> savedChain(opened.geometry(), json))
              .filter(start::isCoveredBy)
              .orElseGet(() -> start.chain(opened.geometry()));
      return ViewerSession.of(opened, this, chain, playerOptions, displayOptions);
    } catch (RuntimeException problem) {
      opened.close();
      throw problem;
    }
  }

  /** The saved chain of a recording or a scene; empty if it is no longer valid. */
  private static Optional<FilterChain> savedChain(SensorGeometry geometry, String json) {
    try {
      return Optional.of(ChainFile.parse(json, "the chain", geometry));
    } catch (IOException | RuntimeException unfit) {
      return Optional.empty();
    }
  }

  /**
   * Creates the {@link #session} of a new window, and lets its player paint the first slice, so
   * that events appear with the window. Background thread.
   */
  public ViewerSession firstSession(Optional<String> chainJson) throws Exception {
    PlayerOptions paused = PlaybackController.firstOptions().withPaused(true);
    return session(chainJson, paused, DisplayOptions.DEFAULT).prepared();
  }
}
