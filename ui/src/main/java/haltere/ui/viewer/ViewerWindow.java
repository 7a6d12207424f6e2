package haltere.ui.viewer;

import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.ui.rendering.ColourMap;
import haltere.ui.viewer.action.ViewerActions;
import haltere.ui.viewer.action.ViewerKeys;
import haltere.ui.viewer.action.ViewerMenu;
import haltere.ui.viewer.chain.ChainEditor;
import haltere.ui.viewer.chain.StageState;
import haltere.ui.viewer.controls.FileDialogs;
import haltere.ui.viewer.controls.Texts;
import haltere.ui.viewer.controls.Theme;
import haltere.ui.viewer.feature.BackgroundWork;
import haltere.ui.viewer.feature.DisplayControl;
import haltere.ui.viewer.feature.LayoutSteps;
import haltere.ui.viewer.feature.StatusLine;
import haltere.ui.viewer.feature.UserSettings;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;
import haltere.ui.viewer.feature.ViewerPanels;
import haltere.ui.viewer.picture.EventView;
import haltere.ui.viewer.playback.PlaybackController;
import haltere.ui.viewer.playback.SeekBar;
import haltere.ui.viewer.plots.PlotPanel;
import haltere.ui.viewer.session.RecordingFacts;
import haltere.ui.viewer.session.SessionHost;
import haltere.ui.viewer.session.SessionRequest;
import haltere.ui.viewer.session.ViewerSession;
import java.io.File;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import java.util.function.BiConsumer;
import javafx.animation.AnimationTimer;
import javafx.animation.PauseTransition;
import javafx.application.Platform;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.geometry.Rectangle2D;
import javafx.scene.Group;
import javafx.scene.Scene;
import javafx.scene.input.DragEvent;
import javafx.scene.input.TransferMode;
import javafx.stage.Screen;
import javafx.stage.Stage;
import javafx.stage.WindowEvent;
import javafx.util.Duration;

/**
 * The viewer's window: holds the session that is open and joins the parts that open and show. What
 * a person can do beyond that its {@link ViewerFeatures features} bring.
 *
 * <p>Thread rule: JavaFX thread only.
 */
public final class ViewerWindow implements SessionHost {
  /** Size at first, where the screen has room for it. */
  private static final double WIDTH = 1200;

  private static final double HEIGHT = 760;

  /** Least size of the window, where the screen has room for it. */
  static final double MIN_WIDTH = 640;

  static final double MIN_HEIGHT = 420;

  private final Stage stage;
  private final BackgroundWork background = new BackgroundWork();
  private final FileDialogs dialogs;
  private final StatusLine statusLine = new StatusLine();
  private final PlaybackController playback = new PlaybackController(statusLine::showError);
  private final ChainEditor editor = new ChainEditor(statusLine::showError, this::showStages);
  private final ViewerActions actions = new ViewerActions();
  private final ViewerMenu menu = new ViewerMenu(actions);
  private final DisplayControl display = new DisplayControl();
  private final ViewerPanels panels = new ViewerPanels(menu, playback, editor, statusLine, display);
  private final List<ViewerFeature> features = ViewerFeatures.all();
  private final LayoutSteps steps;
  private final SourceMemory memory;
  private final List<BiConsumer<String, Exception>> problems = new ArrayList<>();
  private final SessionOpener opener;
  private final AnimationTimer pulse =
      new AnimationTimer() {
        @Override
        public void handle(long nowNanos) {
          session().ifPresent(open -> panels.pulse(open, nowNanos));
        }
      };
  private final ReadOnlyObjectWrapper<Optional<ViewerSession>> session =
      new ReadOnlyObjectWrapper<>(Optional.empty());
  private final ReadOnlyObjectWrapper<Optional<RecordingFacts>> facts =
      new ReadOnlyObjectWrapper<>(Optional.empty());

  /** Fills an empty stage, which the caller shows. */
  public ViewerWindow(Stage stage) {
    this(stage, UserSettings.inMemory());
  }

  /** The same, set up as a user has left it. */
  ViewerWindow(Stage stage, UserSettings settings) {
    this.stage = stage;
    memory = new SourceMemory(settings);
    opener =
        new SessionOpener(
            background, editor, playback, statusLine, memory, this::install, this::failed);
    dialogs = new FileDialogs(stage);
    Rectangle2D room = Screen.getPrimary().getVisualBounds();
    Scene scene =
        new Scene(
            new Group(), Math.min(WIDTH, room.getWidth()), Math.min(HEIGHT, room.getHeight()));
    steps = new LayoutSteps(scene);
    scene.getStylesheets().add(ViewerWindow.class.getResource("viewer.css").toExternalForm());
    // after the style sheet, because each new sheet styles everything anew
    scene.setRoot(panels);
    ViewerKeys.install(scene, actions);
    panels.setOnDragOver(ViewerWindow::dragged);
    panels.setOnDragDropped(this::dropped);
    scene.setFill(Theme.colour(display.options().colours().background()));
    stage.setScene(scene);
    stage.setMinWidth(Math.min(MIN_WIDTH, room.getWidth()));
    stage.setMinHeight(Math.min(MIN_HEIGHT, room.getHeight()));
    stage.setTitle("Haltere");
    stage.setOnHidden(event -> close());
    Thread.currentThread().setUncaughtExceptionHandler((thread, fault) -> showFault(fault));
    followDisplay();
    ViewerContext context =
        new ViewerContext(
            stage,
            this,
            actions,
            playback,
            editor,
            background,
            dialogs,
            statusLine,
            panels,
            steps,
            display,
            settings);
    editor.history().onChange(() -> session().ifPresent(open -> opener.keepChain(open, () -> {})));
    for (ViewerFeature feature : features) {
      actions.beginGroup();
      feature.install(context);
    }
    menu.follow();
    keepWantedSize(room);
    // the keys of playback work at once; a list in the focus would keep some of them
    stage.addEventHandler(
        WindowEvent.WINDOW_SHOWN, event -> Platform.runLater(panels.view()::requestFocus));
    pulse.start();
  }

  /** Asks once more for its size where a window manager has made the new window small. */
  private void keepWantedSize(Rectangle2D room) {
    double width =
        Math.min(Double.isNaN(stage.getWidth()) ? WIDTH : stage.getWidth(), room.getWidth());
    double height =
        Math.min(Double.isNaN(stage.getHeight()) ? HEIGHT : stage.getHeight(), room.getHeight());
    PauseTransition managed = new PauseTransition(Duration.millis(300));
    managed.setOnFinished(
        over -> {
          if (!stage.isMaximized() && stage.getWidth() <= MIN_WIDTH) {
            stage.setWidth(width);
            stage.setHeight(height);
          }
        });
    stage.addEventHandler(WindowEvent.WINDOW_SHOWN, event -> managed.play());
  }

  private void followDisplay() {
    display.onChange(
        () -> {
          session()
              .ifPresent(
                  open -> {
                    open.display().setOptions(display.options());
                    open.player().refresh();
                  });
          ColourMap colours = display.options().colours();
          stage.getScene().setFill(Theme.colour(colours.background()));
        });
    display
        .themeProperty()
        .subscribe(
            (was, is) -> {
              is.apply();
              panels.setDark(is == Theme.DARK);
            });
    display
        .allEventsProperty()
        .subscribe((was, is) -> session().ifPresent(open -> showAllEvents(open, is)));
    display.marksProperty().subscribe((was, is) -> panels.view().setMarksVisible(is));
  }

  private void showAllEvents(ViewerSession open, boolean all) {
    open.display().setAllEvents(all);
    open.player().refresh();
  }

  /** Brings the window to the screen. */
  void show() {
    stage.show();
  }

  /** Shows a session that is being made and whose player was started in pause. */
  public void open(Future<ViewerSession> making, String name, ReadOptions options) {
    opener.open(making, name, options);
  }

  @Override
  public void open(SessionRequest request) {
    opener.open(memory.withSensor(request), session(), display.options());
  }

  private void failed(String name, Exception problem) {
    problems.forEach(listener -> listener.accept(name, problem));
  }

  @Override
  public void onProblem(BiConsumer<String, Exception> listener) {
    problems.add(listener);
  }

  /** Shows a session in place of the one that is open. */
  private void install(ViewerSession made, ReadOptions options) {
    Optional<ViewerSession> before = session();
    playback.setPlayer(made.player());
    editor.setPlayer(made.player());
    stage.setTitle(Texts.source(made.player().playable().name()) + " \u2013 Haltere");
    made.display().setOptions(display.options());
    panels.startAnew(made, display.options().colours(), steps);
    facts.set(Optional.empty());
    session.set(Optional.of(made));
    before.ifPresent(background::close);
    // until then the window has the processors to itself
    steps.afterLayout(() -> begin(made, options));
  }

  private void begin(ViewerSession made, ReadOptions options) {
    if (session().equals(Optional.of(made))) {
      made.play();
      made.file().ifPresent(file -> scan(file, options, made));
    }
  }

  private void scan(Path file, ReadOptions options, ViewerSession scanned) {
    background.scan(
        () -> RecordingFacts.scan(file, options),
        found -> {
          if (session().equals(Optional.of(scanned))) {
            panels.setProfile(found.profile());
            facts.set(Optional.of(found));
          }
        },
        // what is wrong with the file the player says
        problem -> {});
  }

  private void showStages(List<StageState> stages) {
    panels.showStages(stages);
  }

  private static void dragged(DragEvent event) {
    if (event.getDragboard().hasFiles()) {
      event.acceptTransferModes(TransferMode.COPY);
    }
    event.consume();
  }

  private void dropped(DragEvent event) {
    event.setDropCompleted(dropped(event.getDragboard().getFiles()));
    event.consume();
  }

  /** Opens the first of some files; false if there is none. */
  public boolean dropped(List<File> files) {
    if (files.isEmpty()) {
      return false;
    }
    open(files.get(0).toPath());
    return true;
  }

  /** A fault of the viewer itself: the user sees that something is wrong, the log what. */
  private void showFault(Throwable fault) {
    if (fault instanceof RejectedExecutionException) {
      // the process is being ended and JavaFX's painter went first
      return;
    }
    fault.printStackTrace();
    statusLine.showError("Fault in the viewer, please report it: " + fault);
  }

  // What tests and benchmarks look at.

  @Override
  public ReadOnlyObjectProperty<Optional<ViewerSession>> sessionProperty() {
    return session.getReadOnlyProperty();
  }

  @Override
  public ReadOnlyObjectProperty<Optional<RecordingFacts>> factsProperty() {
    return facts.getReadOnlyProperty();
  }

  @Override
  public void keepSensor(SensorGeometry sensor) {
    session().ifPresent(open -> memory.keepSensor(open.request(), sensor));
  }

  /** All that a person can do in the window. */
  public ViewerActions actions() {
    return actions;
  }

  /** How window and events look. */
  public DisplayControl display() {
    return display;
  }

  /** The feature of a class. */
  public <T extends ViewerFeature> T feature(Class<T> type) {
    return features.stream()
        .filter(type::isInstance)
        .map(type::cast)
        .findFirst()
        .orElseThrow(() -> new IllegalArgumentException("no " + type.getSimpleName()));
  }

  /** The transport. */
  public PlaybackController playback() {
    return playback;
  }

  /** Changes and reads the chain that is open. */
  public ChainEditor editor() {
    return editor;
  }

  /** The picture of the events. */
  public EventView view() {
    return panels.view();
  }

  /** The plots of what filters publish. */
  public PlotPanel plots() {
    return panels.plots();
  }

  SeekBar seekBar() {
    return panels.seekBar();
  }

  /** Pictures shown so far. */
  long framesShown() {
    return panels.framesShown();
  }

  private void close() {
    pulse.stop();
    opener.cancel();
    Optional<ViewerSession> last = session();
    session.set(Optional.empty());
    last.ifPresent(background::close);
    panels.plots().close();
    background.close();
  }
}
