package haltere.ui.viewer.controls;

import java.util.function.Consumer;
import javafx.scene.control.TextInputDialog;
import javafx.stage.Window;

/**
 * Asks for a line of text.
 *
 * <p>Thread rule: JavaFX thread only; nothing here waits.
 */
public final class Questions {
  private Questions() {}

  /** Asks, and hands over what was entered unless the question was closed or left empty. */
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
