package haltere.ui.viewer.feature;

import haltere.core.chain.ChainFile;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.playback.PlayerOptions;
import haltere.ui.viewer.chain.ChainAccess;
import haltere.ui.viewer.controls.Texts;
import haltere.ui.viewer.picture.DisplayOptions;
import haltere.ui.viewer.session.RecordingFacts;
import haltere.ui.viewer.session.SessionRequest;
import haltere.ui.viewer.session.ViewerSession;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.Future;
import java.util.function.BiConsumer;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;

/**
 * What is open, and how something else is opened: in the background, one after the other. The one
 * that was asked for last is shown, those before it are closed unseen. What goes wrong the status
 * line says.
 */
public final class Sessions {
  private final SourceMemory memory;
  private final List<BiConsumer<String, Exception>> problems = new ArrayList<>();
  private final ReadOnlyObjectWrapper<Optional<ViewerSession>> session =
      new ReadOnlyObjectWrapper<>(Optional.empty());
  private final ReadOnlyObjectWrapper<Optional<RecordingFacts>> facts =
      new ReadOnlyObjectWrapper<>(Optional.empty());
  private ViewerContext window;
  private int openings;

  /** Nothing is open; chains and sensors are kept in settings. */
  public Sessions(UserSettings settings) {
    memory = new SourceMemory(settings);
  }

  /** Says in which window sessions are shown; called once, before one is opened. */
  public void install(ViewerContext installed) {
    window = installed;
    window.editor().history().onChange(() -> window.ifOpen(open -> keepChain(open, () -> {})));
  }

  /** The session that is shown; empty until the first one has been opened. */
  public ReadOnlyObjectProperty<Optional<ViewerSession>> sessionProperty() {
    return session.getReadOnlyProperty();
  }

  /** The session that is shown. */
  public Optional<ViewerSession> session() {
    return session.get();
  }

  /** What reading all of the recording has told; empty until then, and for what is no recording. */
  public ReadOnlyObjectProperty<Optional<RecordingFacts>> factsProperty() {
    return facts.getReadOnlyProperty();
  }

  /** Tells somebody of what could not be opened, by its name. */
  public void onProblem(BiConsumer<String, Exception> listener) {
    problems.add(listener);
  }

  /** Remembers the sensor of the recording that is open, for the next time that it is opened. */
  public void keepSensor(SensorGeometry sensor) {
    window.ifOpen(open -> memory.keepSensor(open.request(), sensor));
  }

  /** Opens a recording, which tells all that there is to know of it. */
  public void open(Path file) {
    open(file, ReadOptions.DEFAULT);
  }

  /** Opens a recording of which a person has said something. */
  public void open(Path file, ReadOptions options) {
    open(SessionRequest.recording(file, options));
  }

  /**
   * Opens something with the chain of its own in place of what is open, whose chain is kept.
   * Returns at once.
   */
  public void open(SessionRequest asked) {
    SessionRequest request = memory.withSensor(asked);
    int number = announce(request.name());
    PlayerOptions playerOptions = window.playback().options();
    DisplayOptions shownAs = window.display().options();
    Runnable load =
        () -> {
          Optional<String> chainJson = memory.chain(request);
          load(number, () -> request.session(chainJson, playerOptions, shownAs), request.name());
        };
    session().ifPresentOrElse(shown -> keepChain(shown, load), load);
  }

  /** Keeps the chain of what is open, and then goes on. */
  private void keepChain(ViewerSession open, Runnable next) {
    window.read(
        chain ->
            open.request().start().isUnchanged(chain)
                ? Optional.<String>empty()
                : Optional.of(ChainFile.write(chain)),
        json -> {
          memory.keepChain(open.request(), json);
          next.run();
        });
  }

  /** Opens a session of a name that is being made and whose player was started in pause. */
  public void open(Future<ViewerSession> making, String name) {
    int number = announce(name);
    if (making.isDone()) {
      // then the window shows events first
      try {
        handOver(number, making.get());
      } catch (Exception problem) {
        showProblem(number, name, problem);
      }
    } else {
      load(number, making::get, name);
    }
  }

  /** Says what is about to be opened, and that nothing that was asked for before is wanted. */
  private int announce(String name) {
    window.status().clearError();
    window.status().setActivity("Opening " + name + " \u2026");
    return ++openings;
  }

  private void load(int number, Callable<ViewerSession> making, String name) {
    window
        .background()
        .file(
            making, made -> handOver(number, made), problem -> showProblem(number, name, problem));
  }

  private void handOver(int number, ViewerSession made) {
    if (number == openings) {
      show(made);
    } else {
      window.background().close(made);
    }
  }

  private void showProblem(int number, String name, Exception problem) {
    if (number == openings) {
      window.status().setActivity("");
      window.status().showProblem(problem);
      problems.forEach(listener -> listener.accept(name, problem));
    }
  }

  /** Shows a session in place of the one that is open. */
  private void show(ViewerSession made) {
    Optional<ViewerSession> before = session();
    window.playback().setPlayer(made.player());
    window.editor().setAccess(ChainAccess.of(made.player()));
    window.stage().setTitle(Texts.source(made.player().playable().name()) + " \u2013 Haltere");
    made.display().maker().setOptions(window.display().options());
    window.panels().startAnew(made, window.display().options().colours(), window.steps());
    facts.set(Optional.empty());
    session.set(Optional.of(made));
    before.ifPresent(window.background()::close);
    // until then the window has the processors to itself
    window.steps().afterLayout(() -> begin(made));
  }

  private void begin(ViewerSession made) {
    if (isShown(made)) {
      made.play();
      made.request().file().ifPresent(file -> scan(file, made));
    }
  }

  private boolean isShown(ViewerSession made) {
    return session().equals(Optional.of(made));
  }

  private void scan(Path file, ViewerSession scanned) {
    window
        .background()
        .scan(
            () -> RecordingFacts.scan(file, scanned.request().options()),
            found -> {
              if (isShown(scanned)) {
                window.panels().seekBar().setProfile(found.profile());
                facts.set(Optional.of(found));
              }
            },
            // what is wrong with the file the player says
            problem -> {});
  }

  /** Closes what is open; nothing that was asked for is wanted any more. */
  public void close() {
    openings++;
    Optional<ViewerSession> last = session();
    session.set(Optional.empty());
    last.ifPresent(window.background()::close);
  }
}
