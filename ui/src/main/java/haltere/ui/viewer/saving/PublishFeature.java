package haltere.ui.viewer.saving;

import haltere.core.pipeline.LiveResults;
import haltere.core.playback.Player;
import haltere.core.sink.LineOutputs;
import haltere.ui.viewer.controls.Texts;
import haltere.ui.viewer.controls.Windows;
import haltere.ui.viewer.feature.PlaybackOutput;
import haltere.ui.viewer.feature.WindowFeature;
import java.io.IOException;
import java.time.Clock;
import java.util.concurrent.atomic.AtomicReference;
import javafx.application.Platform;

/** Sends results of the filters to other programs during playback. */
public final class PublishFeature extends WindowFeature {
  private record Sending(LiveResults sink) implements PlaybackOutput.Output {
    @Override
    public String startMessage() {
      return "Sending results at " + sink.address();
    }

    @Override
    public String finish() {
      sink.close();
      long lost = sink.lost();
      return lost > 0 ? Texts.count(lost) + " results were not sent: too slow" : "";
    }
  }

  private PlaybackOutput<Sending> sending;
  private String address = "tcp://127.0.0.1:5555";

  @Override
  protected void install() {
    sending = new PlaybackOutput<>(window);
    window
        .actions()
        .add("publish", sending.runningProperty(), () -> sending.toggle(this::ask), () -> "");
  }

  private void ask() {
    Windows.ask(
        window.stage(),
        "Send results",
        "tcp://HOST:PORT listens, udp://HOST:PORT sends, zmq://HOST:PORT binds",
        address,
        this::start);
  }

  /** Begins to send. */
  public void start(String where) {
    address = where;
    sending.start(open -> send(where.strip(), open.player()));
  }

  private Sending send(String where, Player player) throws IOException {
    var output = LineOutputs.open(where);
    AtomicReference<LiveResults> made = new AtomicReference<>();
    player
        .read(chain -> made.set(LiveResults.open(chain, output, name -> true, Clock.systemUTC())))
        .whenComplete(
            (done, problem) -> {
              if (made.get() == null) {
                output.close();
              }
            })
        .join();
    made.get().onFailure(text -> Platform.runLater(() -> window.status().showError(text)));
    return new Sending(made.get());
  }
}
