package haltere.ui.viewer.feature;

import haltere.core.chain.ChainFile;
import haltere.core.chain.FilterChain;
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
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.Future;
import java.util.function.BiConsumer;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.SimpleObjectProperty;

/**
 * The open session. Others are opened in the background, one after the other; only the last
 * requested one is shown. The status line shows problems.
 */
public final class Sessions {
  private final SourceSettings sources;
  private final ObjectProperty<Optional<ViewerSession>> session =
      new SimpleObjectProperty<>(Optional.empty());
  private final ReadOnlyObjectWrapper<Optional<RecordingFacts>> facts =
      new ReadOnlyObjectWrapper<>(Optional.empty());
  private ViewerContext window;
  private BiConsumer<String, Exception> problems = (name, problem) -> {};

  private int openings;
  private ViewerSession unfit;

  /** Without a session; chains and sensors are saved in settings. */
  public Sessions(UserSettings settings) {
    sources = new SourceSettings(settings);
  }

  /** Sets the window of the sessions; called once, before one is opened. */
  public void install(ViewerContext installed) {
    window = installed;
    window.editor().history().onChange(() -> window.ifOpen(open -> saveChain(open, () -> {})));
  }

  /** Adds a listener to changes of the session, which gets the one before and the new one. */
  public void onChange(BiConsumer<Optional<ViewerSession>, Optional<ViewerSession>> listener) {
    session.subscribe(listener);
  }

  /** The session that is shown; empty until the first one has been opened. */
  public Optional<ViewerSession> session() {
    return session.get();
  }

  /** The facts after a scan of the whole recording; empty before, and for other sources. */
  public ReadOnlyObjectProperty<Optional<RecordingFacts>> factsProperty() {
    return facts.getReadOnlyProperty();
  }

  /** Sets the listener to failed openings, by name. */
  public void onProblem(BiConsumer<String, Exception> listener) {
    problems = listener;
  }

  /** Remembers the sensor of the recording that is open, for the next time that it is opened. */
  public void saveSensor(SensorGeometry sensor) {
    window.ifOpen(open -> sources.saveSensor(open.request(), sensor));
  }

  /** Opens a recording that states all its properties. */
  public void open(Path file) {
    open(file, ReadOptions.DEFAULT);
  }

  /** Opens a recording with properties stated by the user. */
  public void open(Path file, ReadOptions options) {
    open(SessionRequest.recording(file, options));
  }

  /**
   * Opens a source with its saved chain in place of the present one, whose chain is saved. Returns
   * at once.
   */
  public void open(SessionRequest asked) {
    SessionRequest request = sources.withSensor(asked);
    int number = announce(request.name());
    PlayerOptions playerOptions = window.playback().options();
    DisplayOptions shownAs = window.display().options();
    Runnable load =
        () -> {
          Optional<String> chainJson = sources.chain(request);
          load(number, () -> request.session(chainJson, playerOptions, shownAs), request.name());
        };
    session().ifPresentOrElse(shown -> saveChain(shown, load), load);
  }

  /** Saves the chain of the open session, and then continues. */
  private void saveChain(ViewerSession open, Runnable next) {
    window.read(
        chain ->
            open.request().start().isUnchanged(chain)
                ? Optional.<String>empty()
                : Optional.of(ChainFile.write(chain)),
        json -> {
          if (json.isPresent() || open != unfit) {
            sources.saveChain(open.request(), json);
          }
          next.run();
        });
  }

  /** Opens a session of a name that is being made and whose player was started in pause. */
  public void open(Future<ViewerSession> making, String name) {
    int number = announce(name);
    if (making.isDone()) {
      // the window shows events first
      try {
        handOver(number, making.get());
      } catch (Exception problem) {
        showProblem(number, name, problem);
      }
    } else {
      load(number, making::get, name);
    }
  }

  /** Announces an opening and cancels earlier requests. */
  private int announce(String name) {
    window.status().clearError();
    window.status().setActivity("Opening " + name + " \u2026");
    return ++openings;
  }

  private void load(int number, Callable<ViewerSession> making, String name) {
    window.file(
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
      problems.accept(name, problem);
    }
  }

  /** Shows a session in place of the open one. */
  private void show(ViewerSession made) {
    Optional<ViewerSession> before = session();
    window.playback().setPlayer(made.player());
    window.editor().setAccess(ChainAccess.of(made.player()));
    String name = Texts.source(made.player().playable().name());
    window.stage().setTitle(name + " \u2013 Haltere");
    window.dialogs().setSource(name);
    made.display().renderer().setOptions(window.display().options());
    window.panels().reset(made, window.display().options().colours(), window.steps());
    facts.set(Optional.empty());
    session.set(Optional.of(made));
    before.ifPresent(window.background()::close);
    // leaves the processors to the window until then
    window.steps().afterLayout(() -> begin(made));
  }

  private void begin(ViewerSession made) {
    if (isShown(made)) {
      made.play();
      made.request().file().ifPresent(file -> scan(file, made));
      sources.chain(made.request()).ifPresent(json -> check(json, made));
    }
  }

  /** Reports a saved chain that cannot be used, such as without an extension, and keeps it. */
  private void check(String json, ViewerSession made) {
    window.file(
        () -> ChainFile.parse(json, "the saved chain", made.chain().geometry()),
        FilterChain::close,
        problem -> {
          unfit = made;
          window.status().showProblem(problem);
        });
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
            // the player reports problems of the file
            problem -> {});
  }

  /** Closes the open session and cancels requests. */
  public void close() {
    openings++;
    Optional<ViewerSession> last = session();
    session.set(Optional.empty());
    last.ifPresent(window.background()::close);
  }
}
