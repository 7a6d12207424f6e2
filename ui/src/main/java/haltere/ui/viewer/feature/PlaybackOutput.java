package haltere.ui.viewer.feature;

import haltere.core.playback.Player;
import haltere.core.stream.StreamHandler;
import haltere.ui.viewer.controls.Texts;
import haltere.ui.viewer.session.ViewerSession;
import java.util.Optional;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;

/**
 * An output during playback, started and finished in the background. It ends when it is stopped, by
 * itself, or when another source is opened.
 *
 * @param <O> the output
 */
public final class PlaybackOutput<O extends PlaybackOutput.Output> {
  /** Something that is written or sent; background threads, one at a time. */
  public interface Output {
    StreamHandler sink();

    String startMessage();

    /** Whether it has ended by itself, such as on a full disk; the JavaFX thread. */
    default boolean isOver() {
      return false;
    }

    /** Ends it; returns a message on the result. */
    String finish() throws Exception;
  }

  /** Creates an output for the open session. */
  @FunctionalInterface
  public interface Factory<O> {
    /** In the background. */
    O create(ViewerSession session) throws Exception;
  }

  private record Active<O>(Player player, O output) {}

  private static final long POLL_NANOS = 250_000_000;

  private final ViewerContext window;
  private final ReadOnlyBooleanWrapper running = new ReadOnlyBooleanWrapper();
  private Optional<Active<O>> active = Optional.empty();
  private int starts;

  /** Nothing is written yet. */
  public PlaybackOutput(ViewerContext window) {
    this.window = window;
    // the session is about to be closed, or closes with the window
    window.sessions().onChange((was, is) -> stop());
    window.panels().every(POLL_NANOS, () -> output().filter(Output::isOver).ifPresent(o -> stop()));
  }

  /** Whether an output is running or starting. */
  public ReadOnlyBooleanProperty runningProperty() {
    return running.getReadOnlyProperty();
  }

  /** The running output. */
  public Optional<O> output() {
    return active.map(Active::output);
  }

  /** Starts an output in place of a running one; no effect without a session. */
  public void start(Factory<O> factory) {
    stop();
    window.ifOpen(open -> start(open, factory));
  }

  private void start(ViewerSession open, Factory<O> factory) {
    int start = ++starts;
    running.set(true);
    window.file(
        () -> new Active<>(open.player(), factory.create(open)),
        made -> begin(start, made),
        problem -> {
          running.set(false);
          window.status().showError(Texts.oneLine(problem));
        });
  }

  private void begin(int start, Active<O> made) {
    if (start != starts || !running.get()) {
      end(made);
      return;
    }
    active = Optional.of(made);
    made.player().addSink(made.output().sink());
    window.status().setActivity(made.output().startMessage());
  }

  /** Ends the running output, or asks for a new one. */
  public void toggle(Runnable ask) {
    if (running.get()) {
      stop();
    } else if (window.sessions().session().isPresent()) {
      ask.run();
    }
  }

  /** Ends the running output, if any. */
  public void stop() {
    running.set(false);
    active.ifPresent(this::end);
    active = Optional.empty();
  }

  private void end(Active<O> ended) {
    window.file(
        () -> {
          // a closed player delivers nothing any more
          ended.player().removeSink(ended.output().sink()).exceptionally(closed -> null).join();
          return ended.output().finish();
        },
        window.status()::setActivity);
  }
}
