package haltere.ui.viewer.wings;

import haltere.core.chain.FilterChain;
import haltere.core.playback.Player;
import haltere.ui.viewer.controls.Texts;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.session.ViewerSession;
import haltere.ui.wing.WingLog;
import haltere.ui.wing.WingLogFormat;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import javafx.application.Platform;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;

/**
 * Writes a log of the wings while it plays. A log ends when it is stopped, or when something else
 * is opened; the file appears then.
 *
 * <p>Thread rule: JavaFX thread only; the log itself belongs to the processing thread.
 */
final class WingLogControl {
  private final ViewerContext window;
  private final ReadOnlyBooleanWrapper writing = new ReadOnlyBooleanWrapper();
  private Optional<WingLog> open = Optional.empty();
  private Path file;
  private Player player;

  WingLogControl(ViewerContext window) {
    this.window = window;
  }

  ReadOnlyBooleanProperty writing() {
    return writing.getReadOnlyProperty();
  }

  /** Starts a log; a file that is there is replaced. */
  void start(Path to, WingLogFormat format) {
    Optional<ViewerSession> session = window.sessions().session();
    if (session.isEmpty()) {
      return;
    }
    player = session.get().player();
    String source = player.playable().name();
    file = to;
    writing.set(true);
    look(chain -> begin(chain, to, source, format), this::fail);
  }

  private void begin(FilterChain chain, Path to, String source, WingLogFormat format) {
    WingsView view =
        WingsView.of(chain)
            .orElseThrow(
                () -> new IllegalArgumentException("there is no wing tracker in the chain"));
    try {
      WingLog log = WingLog.open(to, source, view.filter(), format, true);
      Platform.runLater(() -> begun(log));
    } catch (IOException problem) {
      throw new UncheckedIOException(problem);
    }
  }

  private void begun(WingLog log) {
    open = Optional.of(log);
    window.status().setActivity("Logging wings to " + file.getFileName());
    if (!writing.get()) {
      stop();
    }
  }

  private void fail(String problem) {
    writing.set(false);
    window.status().showError(problem);
  }

  /** Ends the log between two packets. */
  void stop() {
    writing.set(false);
    open.ifPresent(log -> look(chain -> finish(log), window.status()::showError));
    open = Optional.empty();
  }

  /** Ends the log of a session that is about to be closed. */
  void leave() {
    writing.set(false);
    Player last = player;
    open.ifPresent(
        log ->
            window
                .background()
                .file(
                    () -> last.read(chain -> finish(log)).join(),
                    done -> {},
                    problem -> window.status().showError(Texts.oneLine(problem))));
    open = Optional.empty();
  }

  private void look(Consumer<FilterChain> work, Consumer<String> refused) {
    window
        .editor()
        .read(
            chain -> {
              work.accept(chain);
              return chain;
            },
            done -> {},
            refused);
  }

  private void finish(WingLog log) {
    try (log) {
      log.finish();
      long rows = log.rows();
      Platform.runLater(
          () -> window.status().setActivity("Logged " + Texts.count(rows) + " rows of wings"));
    } catch (IOException problem) {
      throw new UncheckedIOException(problem);
    }
  }
}
