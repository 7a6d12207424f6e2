package haltere.ui.viewer;

import haltere.core.chain.ChainFile;
import haltere.core.chain.FilterChain;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RateProfile;
import haltere.core.format.ReadOptions;
import haltere.core.format.Recordings;
import haltere.core.playback.Playable;
import haltere.core.playback.PlayerOptions;
import haltere.core.playback.PlayerStatus;
import haltere.core.playback.PlayerStatus.State;
import haltere.ui.overlay.JavaFxOverlayCanvas;
import haltere.ui.rendering.ColourMap;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import javafx.animation.AnimationTimer;
import javafx.geometry.Orientation;
import javafx.scene.Group;
import javafx.scene.Scene;
import javafx.scene.control.SplitPane;
import javafx.scene.input.DragEvent;
import javafx.scene.input.TransferMode;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.VBox;
import javafx.stage.Stage;

/**
 * The viewer's window: puts the panels together, opens what they are to show, and at each pulse
 * hands them the newest frame and what the player says of itself.
 *
 * <p>Thread rule: JavaFX thread only.
 */
public final class ViewerWindow implements ViewerMenu.Actions {
  /** How often words and numbers are brought up to date while playing. */
  private static final long NUMBERS_NANOS = 125_000_000;

  private static final int PROFILE_BINS = 2000;

  private final Stage stage;
  private final BackgroundWork background = new BackgroundWork();
  private final FileDialogs dialogs;
  private final StatusLine statusLine = new StatusLine();
  private final PlaybackController playback = new PlaybackController(statusLine::showError);
  private final ChainEditor editor = new ChainEditor(statusLine::showError, this::showStages);
  private final EventView view = new EventView();
  private final ChainPanel chainPanel = new ChainPanel(editor);
  private final TransportBar transport = new TransportBar(playback);
  private final SeekBar seekBar = new SeekBar(playback);
  private final Saving saving = new Saving(background, editor, statusLine::showError);
  private final PlotPanel plots = new PlotPanel(editor, playback);
  private final SplitPane left = new SplitPane(view);
  private final ViewerMenu menu = new ViewerMenu(this, playback);
  private final FrameMeter meter = new FrameMeter();
  private final AnimationTimer pulse =
      new AnimationTimer() {
        @Override
        public void handle(long nowNanos) {
          session.ifPresent(open -> pulse(open, nowNanos));
        }
      };
  private Optional<ViewerSession> session = Optional.empty();
  private DisplayOptions displayOptions = DisplayOptions.DEFAULT;
  private PlayerStatus shownStatus;
  private boolean repaintAsked;
  private long numbersNanos;
  private int openings;

  /**
   * Fills a stage, which the caller shows.
   *
   * @param stage an empty stage
   */
  public ViewerWindow(Stage stage) {
    this.stage = stage;
    dialogs = new FileDialogs(stage);
    left.setOrientation(Orientation.VERTICAL);
    SplitPane middle = new SplitPane(left, chainPanel);
    middle.setDividerPositions(0.72);
    SplitPane.setResizableWithParent(chainPanel, false);
    BorderPane root =
        new BorderPane(middle, menu, null, new VBox(seekBar, transport, statusLine), null);
    root.getStyleClass().add("viewer");
    Scene scene = new Scene(new Group(), 1200, 760);
    scene.getStylesheets().add(ViewerWindow.class.getResource("viewer.css").toExternalForm());
    // after the style sheet, because each new sheet styles everything anew
    scene.setRoot(root);
    ViewerKeys.install(scene, playback);
    root.setOnDragOver(ViewerWindow::dragged);
    root.setOnDragDropped(this::dropped);
    scene.setFill(JavaFxOverlayCanvas.colour(displayOptions.colours().background()));
    view.setGeometry(new SensorGeometry(128, 128), displayOptions.colours());
    stage.setScene(scene);
    stage.setTitle("Haltere");
    stage.setOnHidden(event -> close());
    Thread.currentThread().setUncaughtExceptionHandler((thread, fault) -> showFault(fault));
    pulse.start();
  }

  /**
   * Opens a recording in place of what is open, with the same filters. Returns at once.
   *
   * @param file a recording
   * @param options what the user says about it
   */
  public void open(Path file, ReadOptions options) {
    openLater(() -> Sources.recording(file, options), Optional.of(file), options, file.toString());
  }

  /** Opens a playable that is made in the background, with the chain that is open. */
  void open(Callable<Playable> playable, String name) {
    openLater(playable, Optional.empty(), ReadOptions.DEFAULT, name);
  }

  /** Shows a session that is being made and whose player was started in pause. */
  void open(Future<ViewerSession> making, String name, ReadOptions options) {
    int number = announce(name);
    Callable<ViewerSession> made = making::get;
    if (making.isDone()) {
      // then the first thing that the window shows are events
      try {
        install(number, made.call(), options);
      } catch (Exception problem) {
        showOpeningProblem(number, problem);
      }
    } else {
      load(number, made, options);
    }
  }

  private void openLater(
      Callable<Playable> playable, Optional<Path> file, ReadOptions options, String name) {
    int number = announce(name);
    PlayerOptions playerOptions = playback.options();
    DisplayOptions shownAs = displayOptions;
    if (session.isPresent()) {
      editor.read(
          ChainFile::write,
          json ->
              load(
                  number,
                  () -> session(playable, file, Optional.of(json), playerOptions, shownAs),
                  options));
    } else {
      load(
          number, () -> session(playable, file, Optional.empty(), playerOptions, shownAs), options);
    }
  }

  /** Says what is about to be opened, and that nothing that was asked for before is wanted. */
  private int announce(String name) {
    statusLine.clearError();
    statusLine.setActivity("Opening " + name + " \u2026");
    return ++openings;
  }

  private void load(int number, Callable<ViewerSession> making, ReadOptions options) {
    background.file(
        making,
        made -> install(number, made, options),
        problem -> showOpeningProblem(number, problem));
  }

  private void showOpeningProblem(int number, Exception problem) {
    if (number == openings) {
      statusLine.setActivity("");
      statusLine.showError(Texts.oneLine(problem));
    }
  }

  /**
   * Makes the session that a new window shows, and has its player paint the first slice, so that
   * there are events to show as soon as there is a window. Background thread.
   */
  static ViewerSession firstSession(Optional<Path> file, ReadOptions options) throws Exception {
    ViewerSession made =
        session(
            () -> file.isPresent() ? Sources.recording(file.get(), options) : Sources.flyScene(),
            file,
            Optional.empty(),
            PlaybackController.firstOptions().withPaused(true),
            DisplayOptions.DEFAULT);
    made.prepare();
    return made;
  }

  /** Makes a session; background thread. */
  static ViewerSession session(
      Callable<Playable> playable,
      Optional<Path> file,
      Optional<String> chainJson,
      PlayerOptions playerOptions,
      DisplayOptions displayOptions)
      throws Exception {
    Playable opened = playable.call();
    try {
      FilterChain chain = Sources.chain(opened.geometry(), chainJson);
      return new ViewerSession(opened, file, chain, playerOptions, displayOptions);
    } catch (IOException | RuntimeException problem) {
      opened.close();
      throw problem;
    }
  }

  private void install(int number, ViewerSession made, ReadOptions options) {
    if (number != openings) {
      background.close(made);
      return;
    }
    session.ifPresent(background::close);
    session = Optional.of(made);
    playback.setPlayer(made.player());
    editor.setPlayer(made.player());
    String name = made.player().playable().name();
    SensorGeometry geometry = made.player().playable().geometry();
    stage.setTitle(name + " \u2013 Haltere");
    statusLine.setSource(name + "   " + geometry.width() + " \u00d7 " + geometry.height());
    view.setGeometry(geometry, displayOptions.colours());
    made.display().setOptions(displayOptions);
    showStages(made.firstStages());
    plots.startAnew();
    seekBar.clear();
    repaintAsked = false;
    shownStatus = null;
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
            seekBar.setProfile(profile);
          }
        },
        // what is wrong with the file the player says
        problem -> {});
  }

  private void showStages(List<StageState> stages) {
    chainPanel.show(stages);
    plots.followChain();
  }

  private void pulse(ViewerSession open, long nowNanos) {
    DisplayFrame frame = open.display().exchange().fetch();
    if (frame != null) {
      view.show(frame);
      meter.shown();
    } else if (open.display().isStale() && !repaintAsked) {
      repaintAsked = true;
      editor.read(
          chain -> {
            open.display().paint();
            return open;
          },
          painted -> repaintAsked = false);
    }
    PlayerStatus now = open.player().status();
    plots.update(now, nowNanos);
    if (now == shownStatus && nowNanos - numbersNanos < NUMBERS_NANOS) {
      return;
    }
    seekBar.update(now, playback.marks());
    boolean held = now.state() != State.PLAYING;
    if (held || nowNanos - numbersNanos >= NUMBERS_NANOS) {
      showNumbers(open, now, nowNanos);
    }
    shownStatus = now;
  }

  private void showNumbers(ViewerSession open, PlayerStatus now, long nowNanos) {
    transport.update(now);
    statusLine.update(now, meter.perSecond(nowNanos), open.display().exchange().conflated());
    chainPanel.update(nowNanos - numbersNanos);
    numbersNanos = nowNanos;
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
    open(Sources::flyScene, "the fly scene");
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
  public void quit() {
    stage.close();
  }

  @Override
  public void toggleFullScreen() {
    stage.setFullScreen(!stage.isFullScreen());
  }

  @Override
  public void showAll() {
    view.showAll();
  }

  @Override
  public void setTheme(Theme theme) {
    theme.apply();
    seekBar.setDark(theme == Theme.DARK);
    plots.setDark(theme == Theme.DARK);
    menu.showColours(theme.colours());
    setColours(theme.colours());
  }

  @Override
  public void setColours(ColourMap colours) {
    setDisplayOptions(new DisplayOptions(colours, displayOptions.decayUs()));
    view.setBackgroundColour(colours);
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
    view.setMarksVisible(visible);
  }

  @Override
  public void setPlotsVisible(boolean visible) {
    if (visible && !left.getItems().contains(plots)) {
      left.getItems().add(plots);
      left.setDividerPositions(0.6);
    } else if (!visible) {
      left.getItems().remove(plots);
    }
  }

  @Override
  public void savePlotTable() {
    dialogs.table().ifPresent(file -> saving.plots(file, plots.table()));
  }

  @Override
  public void savePlotPicture() {
    dialogs.picture().ifPresent(file -> saving.plots(file, plots.snapshot(null, null)));
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
    return view;
  }

  PlotPanel plots() {
    return plots;
  }

  SeekBar seekBar() {
    return seekBar;
  }

  /** Pictures shown so far. */
  long framesShown() {
    return meter.total();
  }

  private void close() {
    pulse.stop();
    openings++;
    session.ifPresent(background::close);
    session = Optional.empty();
    plots.close();
    background.close();
  }
}
