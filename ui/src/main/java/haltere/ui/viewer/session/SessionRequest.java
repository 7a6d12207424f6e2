package haltere.ui.viewer.session;

import haltere.core.chain.FilterChain;
import haltere.core.format.ReadOptions;
import haltere.core.playback.Playable;
import haltere.core.playback.PlayerOptions;
import haltere.ui.viewer.picture.DisplayOptions;
import haltere.ui.viewer.playback.PlaybackController;
import java.io.IOException;
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
        FirstView.USUAL);
  }

  /** The built-in scene. */
  public static SessionRequest scene() {
    return new SessionRequest(
        Sources::flyScene, Optional.empty(), ReadOptions.DEFAULT, "the fly scene", FirstView.FLY);
  }

  /** What is not a file. */
  static SessionRequest made(Callable<Playable> playable, String name) {
    return new SessionRequest(
        playable, Optional.empty(), ReadOptions.DEFAULT, name, FirstView.USUAL);
  }

  /** A recording, or the built-in scene where there is no file. */
  public static SessionRequest of(Optional<Path> file, ReadOptions options) {
    return file.map(path -> recording(path, options)).orElseGet(SessionRequest::scene);
  }

  /**
   * Makes a session; background thread.
   *
   * @param chainJson the chain as saved, or empty for the one to begin with
   */
  public ViewerSession session(
      Optional<String> chainJson, PlayerOptions playerOptions, DisplayOptions displayOptions)
      throws Exception {
    Playable opened = file.isPresent() ? playable.call() : Sources.kept(playable.call());
    try {
      FilterChain chain =
          chainJson.isPresent()
              ? Sources.chain(opened.geometry(), chainJson.get())
              : start.chain(opened.geometry());
      return new ViewerSession(opened, file, options, chain, start, playerOptions, displayOptions);
    } catch (IOException | RuntimeException problem) {
      opened.close();
      throw problem;
    }
  }

  /**
   * Makes the session that a new window shows, and has its player paint the first slice, so that
   * there are events to show as soon as there is a window. Background thread.
   */
  public ViewerSession firstSession() throws Exception {
    ViewerSession made =
        session(
            Optional.empty(),
            PlaybackController.firstOptions().withPaused(true),
            DisplayOptions.DEFAULT);
    made.prepare();
    return made;
  }
}
