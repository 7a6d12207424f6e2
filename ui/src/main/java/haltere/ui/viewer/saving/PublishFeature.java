package haltere.ui.viewer.saving;

import haltere.core.pipeline.LiveResults;
import haltere.core.playback.Player;
import haltere.core.sink.LineOutputs;
import haltere.ui.viewer.controls.Questions;
import haltere.ui.viewer.controls.Texts;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;
import haltere.ui.viewer.session.ViewerSession;
import java.time.Clock;
import java.util.Optional;
import javafx.application.Platform;
import javafx.beans.property.ReadOnlyBooleanWrapper;

/**
 * Sends what the filters publish to other programs while they run.
 *
 * <p>Thread rule: JavaFX thread only; what waits is done in the background.
 */
public final class PublishFeature implements ViewerFeature {
  private record Under(Player player, LiveResults results) {}

  private final ReadOnlyBooleanWrapper publishing = new ReadOnlyBooleanWrapper();
  private ViewerContext window;
  private Optional<Under> under = Optional.empty();
  private String address = "tcp://127.0.0.1:5555";

  @Override
  public void install(ViewerContext installed) {
    window = installed;
    window.sessions().sessionProperty().subscribe((was, is) -> stop());
    window.actions().add("publish", publishing, this::toggle, () -> "");
  }

  private void toggle() {
    if (publishing.get()) {
      stop();
      return;
    }
    Questions.ask(
        window.stage(),
        "Send results",
        "tcp://HOST:PORT listens, udp://HOST:PORT sends, zmq://HOST:PORT binds",
        address,
        this::start);
  }

  /** Begins to send. */
  public void start(String where) {
    stop();
    address = where;
    window.ifOpen(session -> start(where, session));
  }

  private void start(String where, ViewerSession session) {
    Player player = session.player();
    publishing.set(true);
    window
        .background()
        .file(
            () -> {
              var output = LineOutputs.open(where.strip());
              LiveResults[] made = new LiveResults[1];
              player
                  .read(
                      chain ->
                          made[0] =
                              LiveResults.open(chain, output, name -> true, Clock.systemUTC()))
                  .whenComplete(
                      (done, problem) -> {
                        if (made[0] == null) {
                          output.close();
                        }
                      })
                  .join();
              player.addSink(made[0]);
              return new Under(player, made[0]);
            },
            this::started,
            problem -> {
              publishing.set(false);
              window.status().showError(Texts.oneLine(problem));
            });
  }

  private void started(Under started) {
    if (!publishing.get()) {
      end(started);
      return;
    }
    under = Optional.of(started);
    started.results().onFailure(words -> Platform.runLater(() -> window.status().showError(words)));
    window.status().setActivity("Sending results at " + started.results().address());
  }

  /** Ends the sending, if there is any. */
  public void stop() {
    publishing.set(false);
    under.ifPresent(this::end);
    under = Optional.empty();
  }

  private void end(Under ended) {
    window
        .background()
        .file(
            () -> {
              ended.player().removeSink(ended.results()).exceptionally(closed -> null).join();
              ended.results().close();
              return ended.results().lost();
            },
            lost ->
                window
                    .status()
                    .setActivity(
                        lost > 0 ? Texts.count(lost) + " results were not sent: too slow" : ""),
            problem -> window.status().showError(Texts.oneLine(problem)));
  }

  /** Where results are being sent. */
  public Optional<String> address() {
    return under.map(open -> open.results().address());
  }
}
