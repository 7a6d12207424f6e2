package haltere.ui.viewer.feature;

import haltere.core.chain.ChainFile;
import haltere.core.chain.FilterChain;
import haltere.core.format.AtomicFile;
import haltere.ui.viewer.action.ViewerActions;
import haltere.ui.viewer.chain.ChainEditor;
import haltere.ui.viewer.controls.FileDialogs;
import haltere.ui.viewer.picture.EventView;
import haltere.ui.viewer.picture.ViewTool;
import haltere.ui.viewer.playback.PlaybackController;
import haltere.ui.viewer.session.ViewerSession;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.scene.Node;
import javafx.stage.Stage;

/**
 * The parts of the window that a {@link ViewerFeature} may use.
 *
 * @param stage the window itself
 * @param sessions the open session
 * @param actions the window's commands
 * @param playback the transport
 * @param editor changes and reads the chain between two packets
 * @param background threads for files
 * @param dialogs file dialogs
 * @param status the bottom line
 * @param panels where panels and tools are put
 * @param steps makes large changes of the window, a step at a time
 * @param display how events are shown
 * @param settings saved settings
 */
public record ViewerContext(
    Stage stage,
    Sessions sessions,
    ViewerActions actions,
    PlaybackController playback,
    ChainEditor editor,
    BackgroundWork background,
    FileDialogs dialogs,
    StatusLine status,
    ViewerPanels panels,
    LayoutSteps steps,
    DisplayControl display,
    UserSettings settings) {
  private static final String BY_KEYS = " By keys: arrows, Enter, Esc.";

  /**
   * Offers a panel that can be shown and hidden, with an action for it in the View menu.
   *
   * @param id of the panel and, with {@code show-} before it, of the action
   * @param position where it is shown
   * @param content makes it when it is shown for the first time
   * @return whether it is shown
   */
  public BooleanProperty addPanel(
      String id, PanelLayout.Position position, Supplier<? extends Node> content) {
    String action = "show-" + id;
    BooleanProperty shown =
        panels.panelLayout().offer(id, ViewerActions.label(action), position, content);
    settings.keep("panel." + id, shown);
    actions.add(action, shown);
    return shown;
  }

  /** Adds a listener to a new session before it plays, as one of the {@link #steps()}. */
  public void onSession(Consumer<ViewerSession> listener) {
    sessions.onChange(
        (was, is) ->
            steps.execute(
                () -> is.filter(made -> sessions.session().equals(is)).ifPresent(listener)));
  }

  /** Applies a task to the open session, if any. */
  public void ifOpen(Consumer<ViewerSession> work) {
    sessions.session().ifPresent(work);
  }

  /** Changes how the open session is shown, if any, which shows the moment again. */
  public void refresh(Consumer<ViewerSession> change) {
    ifOpen(change.andThen(open -> open.player().refresh()));
  }

  /** Why nothing can be done with the open source; empty if something is open. */
  public String nothingOpen() {
    return sessions.session().isPresent() ? "" : "nothing is open";
  }

  /** Runs a file task in the background; the bottom line shows problems. */
  public <T> void file(Callable<T> work, Consumer<T> done) {
    file(work, done, status::showProblem);
  }

  /** The same, with problems reported elsewhere. */
  public <T> void file(Callable<T> work, Consumer<T> done, Consumer<Exception> failed) {
    background.file(work, done, failed);
  }

  /** Writes a file in the background; the bottom line confirms it, or shows problems. */
  public void save(Path file, BackgroundWork.Action work) {
    save(work, "Saved " + file.getFileName());
  }

  /** The same, confirmed by other words. */
  public void save(BackgroundWork.Action work, String saved) {
    background.file(work, () -> status.setActivity(saved), status::showProblem);
  }

  /** Writes a text to a file. */
  public void save(Path file, String text) {
    save(file, () -> AtomicFile.write(file, text, true));
  }

  /** Reads from the chain between two packets and returns the result on the JavaFX thread. */
  public <T> void read(Function<FilterChain, T> reading, Consumer<T> consumer) {
    editor.read(reading, consumer);
  }

  /**
   * Reads a saved chain in the background and replaces another one. The bottom line shows a note on
   * settings of an earlier version.
   */
  public void loadChain(Path file, ChainEditor chain) {
    List<String> notes = new ArrayList<>();
    ifOpen(
        open ->
            file(
                () -> ChainFile.read(file, open.chain().geometry(), notes::add),
                loaded -> {
                  chain.replaceAll(loaded);
                  if (!notes.isEmpty()) {
                    status.showError(String.join("; ", notes));
                  }
                }));
  }

  /**
   * Offers a tool of the event view, with an action for it. One tool is selected at a time.
   *
   * @param id of the action
   * @param obstacle the reason why it is unavailable; empty if it is available
   * @return whether it is selected
   */
  public BooleanProperty addTool(String id, ViewTool tool, Supplier<String> obstacle) {
    BooleanProperty on = new SimpleBooleanProperty();
    EventView view = panels.view();
    on.subscribe(
        (was, is) -> {
          if (is) {
            view.setTool(Optional.of(tool));
            showHint(tool);
          } else {
            status.endActivity(tool.hint() + BY_KEYS);
            if (view.tool().filter(held -> held == tool).isPresent()) {
              view.setTool(Optional.empty());
            }
          }
        });
    view.onToolChange(held -> on.set(held.filter(other -> other == tool).isPresent()));
    actions.add(id, on, obstacle);
    return on;
  }

  /** Shows the instructions of a tool, which may change with each click. */
  public void showHint(ViewTool tool) {
    status.setActivity(tool.hint() + BY_KEYS);
  }
}
