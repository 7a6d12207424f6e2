package haltere.ui.viewer;

import haltere.ui.rendering.ColourMap;
import haltere.ui.viewer.action.ViewerActions;
import haltere.ui.viewer.action.ViewerKeys;
import haltere.ui.viewer.action.ViewerMenu;
import haltere.ui.viewer.chain.ChainEditor;
import haltere.ui.viewer.chain.EditHistory;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.FileDialogs;
import haltere.ui.viewer.controls.Theme;
import haltere.ui.viewer.controls.Windows;
import haltere.ui.viewer.feature.BackgroundWork;
import haltere.ui.viewer.feature.DisplayControl;
import haltere.ui.viewer.feature.LayoutSteps;
import haltere.ui.viewer.feature.Sessions;
import haltere.ui.viewer.feature.StatusLine;
import haltere.ui.viewer.feature.UserSettings;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;
import haltere.ui.viewer.feature.ViewerPanels;
import haltere.ui.viewer.playback.PlaybackController;
import haltere.ui.viewer.saving.ExportFeature;
import java.io.File;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.RejectedExecutionException;
import javafx.animation.AnimationTimer;
import javafx.application.Platform;
import javafx.geometry.Rectangle2D;
import javafx.scene.Group;
import javafx.scene.Scene;
import javafx.scene.input.TransferMode;
import javafx.stage.Screen;
import javafx.stage.Stage;
import javafx.stage.WindowEvent;

/**
 * The viewer's window: holds the open session and connects its parts. All else is in {@link
 * ViewerFeatures features}.
 */
public final class ViewerWindow {
  /** Initial size, if the screen has room for it. */
  private static final double WIDTH = 1200;

  private static final double HEIGHT = 760;

  /** Minimum size of the window, if the screen has room for it. */
  static final double MIN_WIDTH = 640;

  static final double MIN_HEIGHT = 420;

  private final Stage stage;
  private final ViewerContext context;
  private final List<ViewerFeature> features = ViewerFeatures.all();
  private final AnimationTimer pulse =
      new AnimationTimer() {
        @Override
        public void handle(long nowNanos) {
          context.ifOpen(open -> context.panels().pulse(open, nowNanos));
        }
      };

  /** Fills an empty stage, which the caller shows, and sets it up as a user has left it. */
  ViewerWindow(Stage stage, UserSettings settings) {
    this.stage = stage;
    Rectangle2D room = Screen.getPrimary().getVisualBounds();
    Scene scene =
        new Scene(
            new Group(), Math.min(WIDTH, room.getWidth()), Math.min(HEIGHT, room.getHeight()));
    StatusLine status = new StatusLine();
    PlaybackController playback = new PlaybackController(status::showError);
    ChainEditor editor = new ChainEditor(status::showError, new EditHistory());
    ViewerActions actions = new ViewerActions();
    actions.onRefusal(status::showRefusal);
    ViewerMenu menu = new ViewerMenu(actions);
    DisplayControl display = new DisplayControl();
    ViewerPanels panels = new ViewerPanels(menu, playback, editor, status, display);
    context =
        new ViewerContext(
            stage,
            new Sessions(settings),
            actions,
            playback,
            editor,
            new BackgroundWork(),
            new FileDialogs(stage),
            status,
            panels,
            new LayoutSteps(scene),
            display,
            settings);
    scene.getStylesheets().add(ViewerWindow.class.getResource("viewer.css").toExternalForm());
    // after the style sheet: each new sheet restyles all nodes
    scene.setRoot(panels);
    ViewerKeys.install(scene, actions);
    Controls.onDrop(
        panels, TransferMode.COPY, board -> Optional.ofNullable(board.getFiles()), this::dropped);
    scene.setFill(Theme.colour(display.options().colours().background()));
    stage.setScene(scene);
    stage.setMinWidth(Math.min(MIN_WIDTH, room.getWidth()));
    stage.setMinHeight(Math.min(MIN_HEIGHT, room.getHeight()));
    stage.setTitle("Haltere");
    stage.setOnHidden(event -> close());
    Thread.currentThread().setUncaughtExceptionHandler((thread, fault) -> showFault(fault));
    followDisplay(display);
    context.sessions().install(context);
    features.forEach(feature -> feature.install(context));
    menu.follow();
    keepWantedSize(room);
    // playback keys work at once; a focused list would consume some of them
    stage.addEventHandler(
        WindowEvent.WINDOW_SHOWN, event -> Platform.runLater(panels.view()::requestFocus));
    pulse.start();
  }

  /** Requests its size again if a window manager has made the new window small. */
  private void keepWantedSize(Rectangle2D room) {
    double width =
        Math.min(Double.isNaN(stage.getWidth()) ? WIDTH : stage.getWidth(), room.getWidth());
    double height =
        Math.min(Double.isNaN(stage.getHeight()) ? HEIGHT : stage.getHeight(), room.getHeight());
    Windows.onceManaged(
        stage,
        () -> {
          if (!stage.isMaximized() && stage.getWidth() <= MIN_WIDTH) {
            stage.setWidth(width);
            stage.setHeight(height);
          }
        });
  }

  private void followDisplay(DisplayControl display) {
    display.onChange(
        () -> {
          context.refresh(open -> open.display().renderer().setOptions(display.options()));
          ColourMap colours = display.options().colours();
          stage.getScene().setFill(Theme.colour(colours.background()));
        });
    ViewerPanels panels = context.panels();
    display
        .themeProperty()
        .subscribe(
            (was, is) -> {
              is.apply();
              panels.setDark(is == Theme.DARK);
            });
    display
        .allEventsProperty()
        .subscribe((was, is) -> context.refresh(open -> open.display().setAllEvents(is)));
    display.marksProperty().subscribe((was, is) -> panels.view().setMarksVisible(is));
  }

  /** Opens a file, and refuses several with a line; false for an empty list. */
  public boolean dropped(List<File> files) {
    if (files.size() == 1) {
      context.sessions().open(files.get(0).toPath());
    } else if (!files.isEmpty()) {
      context.status().showRefusal("A window shows one recording: drop a single file");
    }
    return !files.isEmpty();
  }

  /** Shows a fault of the viewer: a line for the user, details in the log. */
  private void showFault(Throwable fault) {
    if (fault instanceof RejectedExecutionException) {
      // the process ends and JavaFX's renderer has already stopped
      return;
    }
    fault.printStackTrace();
    context.status().showError("Fault in the viewer, please report it: " + fault);
  }

  /** The parts of the window. */
  public ViewerContext context() {
    return context;
  }

  /** The feature of a class. */
  public <T extends ViewerFeature> T feature(Class<T> type) {
    return features.stream()
        .filter(type::isInstance)
        .map(type::cast)
        .findFirst()
        .orElseThrow(() -> new IllegalArgumentException("no " + type.getSimpleName()));
  }

  private void close() {
    pulse.stop();
    context.sessions().close();
    context.panels().plots().close();
    feature(ExportFeature.class).stop();
    context.background().close();
  }
}
