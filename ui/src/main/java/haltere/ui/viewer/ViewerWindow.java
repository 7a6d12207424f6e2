package haltere.ui.viewer;

import haltere.core.chain.ChainFile;
import haltere.core.format.RateProfile;
import haltere.core.format.ReadOptions;
import haltere.core.format.Recordings;
import haltere.core.playback.Playable;
import haltere.ui.overlay.JavaFxOverlayCanvas;
import haltere.ui.rendering.ColourMap;
import java.io.File;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import javafx.animation.AnimationTimer;
import javafx.scene.Group;
import javafx.scene.Scene;
import javafx.scene.input.DragEvent;
import javafx.scene.input.TransferMode;
import javafx.stage.Stage;

/**
 * The viewer's window: holds the session that is open, puts what the menus ask for into effect and
 * joins the parts that open, show and save.
 *
 * <p>Thread rule: JavaFX thread only.
 */
public final class ViewerWindow implements ViewerMenu.Actions {
  private static final int PROFILE_BINS = 2000;

  private final Stage stage;
  private final BackgroundWork background = new BackgroundWork();
  private final FileDialogs dialogs;
  private final StatusLine statusLine = new StatusLine();
  private final PlaybackController playback = new PlaybackController(statusLine::showError);
  private final ChainEditor editor = new ChainEditor(statusLine::showError, this::showStages);
  private final Saving saving = new Saving(background, editor, statusLine::showError);
  private final ViewerMenu menu = new ViewerMenu(this, playback);
  private final ViewerPanels panels = new ViewerPanels(menu, playback, editor, statusLine);
  private final RecordingControl recording =
      new RecordingControl(background, statusLine::showError, statusLine::setActivity);
  private final SessionOpener opener =
      new SessionOpener(background, editor, playback, statusLine, this::install);
  private final AnimationTimer pulse =
      new AnimationTimer() {
        @Override
        public void handle(long nowNanos) {
          session.ifPresent(open -> panels.pulse(open, nowNanos));
        }
      };
  private Optional<ViewerSession> session = Optional.empty();
  private DisplayOptions displayOptions = DisplayOptions.DEFAULT;

  /**
   * Fills a stage, which the caller shows.
   *
   * @param stage an empty stage
   */
  public ViewerWindow(Stage stage) {
    this.stage = stage;
    dialogs = new FileDialogs(stage);
    Scene scene = new Scene(new Group(), 1200, 760);
    scene.getStylesheets().add(ViewerWindow.class.getResource("viewer.css").toExternalForm());
    // after the style sheet, because each new sheet styles everything anew
    scene.setRoot(panels);
    ViewerKeys.install(scene, playback);
    panels.setOnDragOver(ViewerWindow::dragged);
    panels.setOnDragDropped(this::dropped);
    scene.setFill(JavaFxOverlayCanvas.colour(displayOptions.colours().background()));
    stage.setScene(scene);
    stage.setTitle("Haltere");
    stage.setOnHidden(event -> close());
    Thread.currentThread().setUncaughtExceptionHandler((thread, fault) -> showFault(fault));
    recording.recordingProperty().addListener((property, was, is) -> menu.showRecording(is));
    pulse.start();
  }

  /**
   * Opens a recording in place of what is open. Filters that a person has chosen stay. Returns at
   * once.
   *
   * @param file a recording
   * @param options what the user says about it
   */
  public void open(Path file, ReadOptions options) {
    open(SessionRequest.recording(file, options));
  }

  /** Opens a playable that is made in the background, with the chain that is open. */
  void open(Callable<Playable> playable, String name) {
    open(SessionRequest.made(playable, name));
  }

  /** Shows a session that is being made and whose player was started in pause. */
  void open(Future<ViewerSession> making, String name, ReadOptions options) {
    opener.open(making, name, options);
  }

  private void open(SessionRequest request) {
    opener.open(request, session, displayOptions);
  }

  /** Shows a session in place of the one that is open. */
  private void install(ViewerSession made, ReadOptions options) {
    recording.stop();
    session.ifPresent(background::close);
    session = Optional.of(made);
    playback.setPlayer(made.player());
    editor.setPlayer(made.player());
    stage.setTitle(made.player().playable().name() + " \u2013 Haltere");
    made.display().setOptions(displayOptions);
    panels.startAnew(made, displayOptions.colours());
    if (panels.plots().beginWith(made.start().plots())) {
      menu.showPlots();
      panels.setPlotsVisible(true);
    }
    made.play();
    made.file().ifPresent(file -> scanRates(file, options, made));
  }

  private void scanRates(Path file, ReadOptions options, ViewerSession scanned) {
    background.scan(
        () -> {
          try (var reader = Recordings.open(file, options)) {
            return RateProfile.scan(reader, PROFILE_BINS);
          }
        },
        profile -> {
          if (session.equals(Optional.of(scanned))) {
            panels.setProfile(profile);
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
  boolean dropped(List<File> files) {
    if (files.isEmpty()) {
      return false;
    }
    open(files.get(0).toPath(), ReadOptions.DEFAULT);
    return true;
  }

  @Override
  public void openFile() {
    dialogs.recording().ifPresent(file -> open(file, ReadOptions.DEFAULT));
  }

  @Override
  public void openScene() {
    open(SessionRequest.scene());
  }

  @Override
  public void loadChain() {
    dialogs.chainToLoad().ifPresent(this::loadChain);
  }

  /** Puts a saved chain in place of the one that is open. */
  void loadChain(Path file) {
    session.ifPresent(
        open ->
            background.file(
                () -> ChainFile.read(file, open.chain().geometry()),
                editor::replaceAll,
                problem -> statusLine.showError(Texts.oneLine(problem))));
  }

  @Override
  public void saveChain() {
    dialogs.chainToSave().ifPresent(this::saveChain);
  }

  /** Saves the chain that is open; a file that is there is replaced. */
  void saveChain(Path file) {
    saving.chain(file);
  }

  @Override
  public void savePicture() {
    dialogs.picture().ifPresent(this::savePicture);
  }

  /** Saves what is shown as a picture; a file that is there is replaced. */
  void savePicture(Path file) {
    session.ifPresent(open -> saving.picture(file, open));
  }

  @Override
  public void toggleRecording() {
    if (recording.recordingProperty().get()) {
      recording.stop();
    } else if (session.isPresent()) {
      dialogs.recordingToWrite().ifPresent(this::record);
    }
  }

  /** Records what comes out of the chain; a file that is there is replaced. */
  void record(Path file) {
    session.ifPresent(open -> recording.start(file, open.player()));
  }

  RecordingControl recording() {
    return recording;
  }

  @Override
  public void quit() {
    stage.close();
  }

  @Override
  public void toggleFullScreen() {
    stage.setFullScreen(!stage.isFullScreen());
  }

  @Override
  public void showAll() {
    panels.view().showAll();
  }

  @Override
  public void setTheme(Theme theme) {
    theme.apply();
    panels.setDark(theme == Theme.DARK);
    menu.showColours(theme.colours());
    setColours(theme.colours());
  }

  @Override
  public void setColours(ColourMap colours) {
    setDisplayOptions(new DisplayOptions(colours, displayOptions.decayUs()));
    panels.view().setBackgroundColour(colours);
    stage.getScene().setFill(JavaFxOverlayCanvas.colour(colours.background()));
  }

  @Override
  public void setDecay(long decayUs) {
    setDisplayOptions(new DisplayOptions(displayOptions.colours(), decayUs));
  }

  private void setDisplayOptions(DisplayOptions options) {
    displayOptions = options;
    session.ifPresent(open -> open.display().setOptions(options));
  }

  @Override
  public void setMarksVisible(boolean visible) {
    panels.view().setMarksVisible(visible);
  }

  @Override
  public void setPlotsVisible(boolean visible) {
    panels.setPlotsVisible(visible);
  }

  @Override
  public void savePlotTable() {
    dialogs.table().ifPresent(file -> saving.plots(file, panels.plots().table()));
  }

  @Override
  public void savePlotPicture() {
    dialogs.picture().ifPresent(file -> saving.plots(file, panels.plots().snapshot(null, null)));
  }

  @Override
  public void showKeys() {
    KeysDialog.show(stage);
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

  Optional<ViewerSession> session() {
    return session;
  }

  PlaybackController playback() {
    return playback;
  }

  EventView view() {
    return panels.view();
  }

  PlotPanel plots() {
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
    recording.stop();
    session.ifPresent(background::close);
    session = Optional.empty();
    panels.plots().close();
    background.close();
  }
}
