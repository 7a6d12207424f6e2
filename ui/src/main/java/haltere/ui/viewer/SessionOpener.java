package haltere.ui.viewer;

import haltere.core.chain.ChainFile;
import haltere.core.format.ReadOptions;
import haltere.core.playback.PlayerOptions;
import haltere.ui.viewer.chain.ChainEditor;
import haltere.ui.viewer.feature.BackgroundWork;
import haltere.ui.viewer.feature.StatusLine;
import haltere.ui.viewer.picture.DisplayOptions;
import haltere.ui.viewer.playback.PlaybackController;
import haltere.ui.viewer.session.SessionRequest;
import haltere.ui.viewer.session.ViewerSession;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.Future;
import java.util.function.BiConsumer;

/**
 * Opens sessions in the background, one after the other, and hands over the one that was asked for
 * last; those before it are closed unseen. What goes wrong the status line says.
 *
 * <p>Thread rule: JavaFX thread only; nothing here waits.
 */
final class SessionOpener {
  private final BackgroundWork background;
  private final ChainEditor editor;
  private final PlaybackController playback;
  private final StatusLine statusLine;
  private final SourceMemory memory;
  private final BiConsumer<ViewerSession, ReadOptions> opened;
  private final BiConsumer<String, Exception> failed;
  private int openings;

  /** An opener that hands over each session together with what the user said of its file. */
  SessionOpener(
      BackgroundWork background,
      ChainEditor editor,
      PlaybackController playback,
      StatusLine statusLine,
      SourceMemory memory,
      BiConsumer<ViewerSession, ReadOptions> opened,
      BiConsumer<String, Exception> failed) {
    this.background = background;
    this.editor = editor;
    this.playback = playback;
    this.statusLine = statusLine;
    this.memory = memory;
    this.opened = opened;
    this.failed = failed;
  }

  /**
   * Opens something with the chain of its own and its events shown in a way; the chain of what is
   * open now is kept.
   */
  void open(SessionRequest request, Optional<ViewerSession> open, DisplayOptions shownAs) {
    int number = announce(request.name());
    PlayerOptions playerOptions = playback.options();
    Runnable load =
        () -> {
          Optional<String> chainJson = memory.chain(request);
          load(
              number,
              () -> request.session(chainJson, playerOptions, shownAs),
              request.name(),
              request.options());
        };
    open.ifPresentOrElse(shown -> keepChain(shown, load), load);
  }

  /** Keeps the chain of what is open, and then goes on. */
  void keepChain(ViewerSession open, Runnable next) {
    editor.read(
        chain ->
            open.start().isUnchanged(chain)
                ? Optional.<String>empty()
                : Optional.of(ChainFile.write(chain)),
        json -> {
          memory.keepChain(open.request(), json);
          next.run();
        });
  }

  /** Opens a session that is being made and whose player was started in pause. */
  void open(Future<ViewerSession> making, String name, ReadOptions options) {
    int number = announce(name);
    Callable<ViewerSession> made = making::get;
    if (making.isDone()) {
      // then the window shows events first
      try {
        handOver(number, made.call(), options);
      } catch (Exception problem) {
        showProblem(number, name, problem);
      }
    } else {
      load(number, made, name, options);
    }
  }

  /** Nothing that was asked for is wanted any more. */
  void cancel() {
    openings++;
  }

  /** Says what is about to be opened, and that nothing that was asked for before is wanted. */
  private int announce(String name) {
    statusLine.clearError();
    statusLine.setActivity("Opening " + name + " \u2026");
    return ++openings;
  }

  private void load(int number, Callable<ViewerSession> making, String name, ReadOptions options) {
    background.file(
        making,
        made -> handOver(number, made, options),
        problem -> showProblem(number, name, problem));
  }

  private void handOver(int number, ViewerSession made, ReadOptions options) {
    if (number == openings) {
      opened.accept(made, options);
    } else {
      background.close(made);
    }
  }

  private void showProblem(int number, String name, Exception problem) {
    if (number == openings) {
      statusLine.setActivity("");
      statusLine.showProblem(problem);
      failed.accept(name, problem);
    }
  }
}
