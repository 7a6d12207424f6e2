package haltere.ui.viewer.session;

import haltere.core.chain.FilterChain;
import haltere.core.format.ReadOptions;
import haltere.core.playback.Playable;
import haltere.core.playback.PlayerOptions;
import haltere.ui.viewer.picture.DisplayOptions;
import haltere.ui.viewer.playback.PlaybackController;
import java.nio.file.Path;
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
  /** A recording. */
  public static SessionRequest recording(Path file, ReadOptions options) {
    return new SessionRequest(
        () -> Sources.recording(file, options),
        Optional.of(file),
        options,
        file.toString(),
        FirstView.RAW);
  }

  /** The built-in scene. */
  public static SessionRequest scene() {
    return new SessionRequest(
        Sources::flyScene, Optional.empty(), ReadOptions.DEFAULT, "the fly scene", FirstView.FLY);
  }

  /**
   * A simulated scene by its name on the command line, such as {@code road}, with the title that a
   * person calls it.
   */
  public static SessionRequest scene(String scene, String title) {
    return scene.equals("fly")
        ? scene()
        : new SessionRequest(
            () -> Sources.scene(scene, title),
            Optional.empty(),
            ReadOptions.DEFAULT,
            title,
            scene.endsWith("fly") ? FirstView.FLY : FirstView.OBJECTS);
  }

  /** What is not a file. */
  static SessionRequest made(Callable<Playable> playable, String name) {
    return new SessionRequest(playable, Optional.empty(), ReadOptions.DEFAULT, name, FirstView.RAW);
  }

  /** A recording, or the built-in scene where there is no file. */
  public static SessionRequest of(Optional<Path> file, ReadOptions options) {
    return file.map(path -> recording(path, options)).orElseGet(SessionRequest::scene);
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
    Playable opened = file.isPresent() ? playable.call() : Sources.kept(playable.call());
    try {
      FilterChain chain =
          chainJson
              .flatMap(json -> Sources.ownChain(opened.geometry(), json))
              .filter(start::isCoveredBy)
              .orElseGet(() -> start.chain(opened.geometry()));
      return new ViewerSession(opened, this, chain, playerOptions, displayOptions);
    } catch (RuntimeException problem) {
      opened.close();
      throw problem;
    }
  }

  /**
   * Makes the {@link #session} that a new window shows, and has its player paint the first slice,
   * so that there are events to show as soon as there is a window. Background thread.
   */
  public ViewerSession firstSession(Optional<String> chainJson) throws Exception {
    ViewerSession made =
        session(
            chainJson, PlaybackController.firstOptions().withPaused(true), DisplayOptions.DEFAULT);
    made.prepare();
    return made;
  }
}
