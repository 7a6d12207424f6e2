package haltere.ui.viewer.controls;

import java.util.function.Consumer;
import java.util.function.Supplier;
import javafx.animation.PauseTransition;
import javafx.geometry.Dimension2D;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.Scene;
import javafx.scene.control.Alert;
import javafx.scene.control.ButtonType;
import javafx.scene.control.Dialog;
import javafx.scene.control.DialogPane;
import javafx.scene.control.TextInputDialog;
import javafx.stage.Modality;
import javafx.stage.Stage;
import javafx.stage.Window;
import javafx.stage.WindowEvent;
import javafx.util.Duration;

/** Opens further windows and dialogs in the style of the viewer. */
public final class Windows {
  /** Tolerance of a window's size. */
  private static final double TOLERANCE_PX = 20;

  private Windows() {}

  /** A window that is closed with its owner, and not shown yet. */
  public static Stage beside(Stage owner, String title, Parent root, double width, double height) {
    Stage stage = new Stage();
    stage.initOwner(owner);
    stage.setTitle(title);
    Scene scene = new Scene(root, width, height);
    scene.getStylesheets().setAll(owner.getScene().getStylesheets());
    scene.setFill(owner.getScene().getFill());
    stage.setScene(scene);
    keepSize(stage, () -> new Dimension2D(width, height));
    stage.setMinWidth(width / 2);
    stage.setMinHeight(height / 2);
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
    DialogPane pane = dialog.getDialogPane();
    Window window = pane.getScene().getWindow();
    keepSize(window, () -> new Dimension2D(pane.prefWidth(-1), pane.prefHeight(-1)));
    dialog.show();
    // some window managers ignore the position of a new window
    Window owner = dialog.getOwner();
    window.setX(owner.getX() + (owner.getWidth() - window.getWidth()) / 2);
    window.setY(owner.getY() + (owner.getHeight() - window.getHeight()) / 2);
  }

  /** Requests the size of a window's content again if a window manager has made it small. */
  private static void keepSize(Window window, Supplier<Dimension2D> size) {
    PauseTransition managed = new PauseTransition(Duration.millis(300));
    managed.setOnFinished(
        over -> {
          double wider = size.get().getWidth() - window.getScene().getWidth();
          double higher = size.get().getHeight() - window.getScene().getHeight();
          if (wider > TOLERANCE_PX || higher > TOLERANCE_PX) {
            window.setWidth(window.getWidth() + Math.max(0, wider));
            window.setHeight(window.getHeight() + Math.max(0, higher));
            window.centerOnScreen();
          }
        });
    window.addEventHandler(WindowEvent.WINDOW_SHOWN, event -> managed.play());
  }

  /** Asks for a line of text, and passes it on unless the dialog was cancelled or left empty. */
  public static void ask(
      Window owner, String title, String text, String usual, Consumer<String> answer) {
    TextInputDialog dialog = new TextInputDialog(usual);
    dialog.initOwner(owner);
    dialog.setTitle(title);
    dialog.setHeaderText(null);
    dialog.setGraphic(null);
    dialog.setContentText(text);
    dialog.getEditor().setId("answer");
    dialog.getEditor().setAccessibleText(text);
    dialog
        .resultProperty()
        .subscribe(
            (was, is) -> {
              if (is != null && !is.isBlank()) {
                answer.accept(is.strip());
              }
            });
    show(dialog);
  }
}
