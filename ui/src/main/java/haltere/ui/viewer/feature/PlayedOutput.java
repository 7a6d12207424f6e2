package haltere.ui.viewer.feature;

import haltere.core.playback.Player;
import haltere.core.stream.StreamHandler;
import haltere.ui.viewer.controls.Texts;
import haltere.ui.viewer.session.ViewerSession;
import java.util.Optional;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;

/**
 * What is written or sent while something plays: made and ended in the background. It ends when it
 * is stopped, or when something else is opened.
 *
 * @param <O> what is written or sent
 */
public final class PlayedOutput<O extends PlayedOutput.Output> {
  /** Something that is written or sent; background threads, one at a time. */
  public interface Output {
    /** What it gets of the stream. */
    StreamHandler sink();

    /** What a person is told once it is under way. */
    String begun();

    /** Ends it; what came of it, in words for a person. */
    String finish() throws Exception;
  }

  /** Makes an output for what is open. */
  @FunctionalInterface
  public interface Maker<O> {
    /** In the background. */
    O make(ViewerSession session) throws Exception;
  }

  private record Under<O>(Player player, O output) {}

  private final ViewerContext window;
  private final ReadOnlyBooleanWrapper running = new ReadOnlyBooleanWrapper();
  private Optional<Under<O>> under = Optional.empty();
  private int starts;

  /** Nothing is written yet. */
  public PlayedOutput(ViewerContext window) {
    this.window = window;
    // what is open is about to be closed, or is closed with the window
    window.sessions().sessionProperty().subscribe((was, is) -> stop());
  }

  /** Whether something is written, or about to be. */
  public ReadOnlyBooleanProperty runningProperty() {
    return running.getReadOnlyProperty();
  }

  /** What is written. */
  public Optional<O> output() {
    return under.map(Under::output);
  }

  /** Begins, in place of what is written; does nothing where nothing is open. */
  public void start(Maker<O> maker) {
    stop();
    window.ifOpen(open -> start(open, maker));
  }

  private void start(ViewerSession open, Maker<O> maker) {
    int start = ++starts;
    running.set(true);
    window
        .background()
        .file(
            () -> new Under<>(open.player(), maker.make(open)),
            made -> begin(start, made),
            problem -> {
              running.set(false);
              window.status().showError(Texts.oneLine(problem));
            });
  }

  private void begin(int start, Under<O> made) {
    if (start != starts || !running.get()) {
      end(made);
      return;
    }
    under = Optional.of(made);
    made.player().addSink(made.output().sink());
    window.status().setActivity(made.output().begun());
  }

  /** Ends what is written, or asks for what is to be written. */
  public void toggle(Runnable ask) {
    if (running.get()) {
      stop();
    } else if (window.sessions().session().isPresent()) {
      ask.run();
    }
  }

  /** Ends what is written, if there is any. */
  public void stop() {
    running.set(false);
    under.ifPresent(this::end);
    under = Optional.empty();
  }

  private void end(Under<O> ended) {
    window.file(
        () -> {
          // a player that has been closed hands over nothing more anyway
          ended.player().removeSink(ended.output().sink()).exceptionally(closed -> null).join();
          return ended.output().finish();
        },
        window.status()::setActivity);
  }
}
