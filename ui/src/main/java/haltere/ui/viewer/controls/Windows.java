package haltere.ui.viewer.controls;

import java.util.Collection;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Predicate;
import javafx.animation.PauseTransition;
import javafx.application.Platform;
import javafx.geometry.Rectangle2D;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.Scene;
import javafx.scene.control.Alert;
import javafx.scene.control.ButtonType;
import javafx.scene.control.Dialog;
import javafx.scene.control.TextInputDialog;
import javafx.stage.Modality;
import javafx.stage.Screen;
import javafx.stage.Stage;
import javafx.stage.Window;
import javafx.stage.WindowEvent;
import javafx.util.Duration;

/** Opens further windows and dialogs in the style of the viewer. */
public final class Windows {
  private Windows() {}

  /** A window that is closed with its owner, no larger than the screen, and not shown yet. */
  public static Stage beside(Stage owner, String title, Parent root, double width, double height) {
    Stage stage = new Stage();
    stage.initOwner(owner);
    stage.setTitle(title);
    Rectangle2D room = Screen.getPrimary().getVisualBounds();
    Scene scene =
        new Scene(root, Math.min(width, room.getWidth()), Math.min(height, room.getHeight()));
    scene.getStylesheets().setAll(owner.getScene().getStylesheets());
    scene.setFill(owner.getScene().getFill());
    stage.setScene(scene);
    keepSize(stage, stage::centerOnScreen);
    stage.setMinWidth(scene.getWidth() / 2);
    stage.setMinHeight(scene.getHeight() / 2);
    return stage;
  }

  /** Shows content to read, with a button that closes it. */
  public static void showContent(Window owner, String title, Node content) {
    Alert alert = new Alert(Alert.AlertType.NONE, "", ButtonType.CLOSE);
    alert.setTitle(title);
    alert.getDialogPane().setContent(content);
    alert.initOwner(owner);
    alert.initModality(Modality.NONE);
    show(alert);
  }

  private static void show(Dialog<?> dialog) {
    Window window = dialog.getDialogPane().getScene().getWindow();
    keepSize(window, () -> centre(window, dialog.getOwner()));
    dialog.show();
    // some window managers ignore the position of a new window
    centre(window, dialog.getOwner());
  }

  /** Moves a window over its owner, with its title on the screen. */
  private static void centre(Window window, Window owner) {
    window.setX(owner.getX() + (owner.getWidth() - window.getWidth()) / 2);
    window.setY(owner.getY() + Math.max(0, (owner.getHeight() - window.getHeight()) / 2));
  }

  /** Requests a new window's own size again: some window managers make it small. */
  private static void keepSize(Window window, Runnable place) {
    onceManaged(
        window,
        () -> {
          double width = window.getWidth();
          window.sizeToScene();
          if (window.getWidth() > width) {
            place.run();
          }
        });
  }

  /** Runs something when a window manager, if there is one, has placed and framed a new window. */
  public static void onceManaged(Window window, Runnable then) {
    PauseTransition managed = new PauseTransition(Duration.millis(300));
    managed.setOnFinished(
        over -> {
          if (window.getWidth() > window.getScene().getWidth()) {
            then.run();
          }
        });
    window.addEventHandler(WindowEvent.WINDOW_SHOWN, event -> managed.play());
  }

  /** Asks for a name of something to save; one that is used has to be confirmed. */
  public static void askName(
      Window owner, String kind, Collection<String> used, Consumer<String> named) {
    ask(
        owner,
        Texts.capital(kind),
        "Name of the " + kind,
        "",
        name -> {
          if (used.contains(name)) {
            Alert alert = new Alert(Alert.AlertType.CONFIRMATION, "Replace " + name + "?");
            ask(owner, alert, ButtonType.OK::equals, ok -> named.accept(name));
          } else {
            named.accept(name);
          }
        });
  }

  /** Asks for a line of text, and passes it on unless the dialog was cancelled or left empty. */
  public static void ask(
      Window owner, String title, String text, String usual, Consumer<String> answer) {
    TextInputDialog dialog = new TextInputDialog(usual);
    dialog.setTitle(title);
    dialog.setGraphic(null);
    dialog.setContentText(text);
    dialog.getEditor().setId("answer");
    dialog.getEditor().setAccessibleText(text);
    ask(owner, dialog, line -> !line.isBlank(), line -> answer.accept(line.strip()));
  }

  private static <T> void ask(
      Window owner, Dialog<T> dialog, Predicate<T> isAnswer, Consumer<T> answer) {
    dialog.initOwner(owner);
    dialog.setHeaderText(null);
    // later: GTK's key that closes a window must not open another one, which ends the process
    dialog.setOnHidden(
        event ->
            Platform.runLater(
                () -> Optional.ofNullable(dialog.getResult()).filter(isAnswer).ifPresent(answer)));
    show(dialog);
  }
}
