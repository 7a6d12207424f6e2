package haltere.ui.viewer.controls;

import java.util.function.Consumer;
import javafx.scene.Node;
import javafx.scene.Parent;
import javafx.scene.Scene;
import javafx.scene.control.Alert;
import javafx.scene.control.ButtonType;
import javafx.scene.control.TextInputDialog;
import javafx.stage.Modality;
import javafx.stage.Stage;
import javafx.stage.Window;

/**
 * Opens windows and questions beside the viewer's own window, in its style.
 *
 * <p>Thread rule: JavaFX thread only; nothing here waits.
 */
public final class Windows {
  private Windows() {}

  /** A window that is closed with its owner, and not shown yet. */
  public static Stage beside(Stage owner, String title, Parent root, double width, double height) {
    Stage stage = new Stage();
    stage.initOwner(owner);
    stage.setTitle(title);
    Scene scene = new Scene(root, width, height);
    scene.getStylesheets().setAll(owner.getScene().getStylesheets());
    stage.setScene(scene);
    stage.setMinWidth(width / 2);
    stage.setMinHeight(height / 2);
    return stage;
  }

  /** Shows something to read, with a button that closes it. */
  public static void tell(Window owner, String title, Node content) {
    Alert alert = new Alert(Alert.AlertType.NONE, "", ButtonType.CLOSE);
    alert.setTitle(title);
    alert.getDialogPane().setContent(content);
    alert.initOwner(owner);
    alert.initModality(Modality.NONE);
    alert.show();
  }

  /**
   * Asks for a line of text, and hands over what was entered unless the question was closed or left
   * empty.
   */
  public static void ask(
      Window owner, String title, String words, String usual, Consumer<String> answer) {
    TextInputDialog dialog = new TextInputDialog(usual);
    dialog.initOwner(owner);
    dialog.setTitle(title);
    dialog.setHeaderText(null);
    dialog.setGraphic(null);
    dialog.setContentText(words);
    dialog.getEditor().setId("answer");
    dialog.getEditor().setAccessibleText(words);
    dialog
        .resultProperty()
        .subscribe(
            (was, is) -> {
              if (is != null && !is.isBlank()) {
                answer.accept(is.strip());
              }
            });
    dialog.show();
  }
}
