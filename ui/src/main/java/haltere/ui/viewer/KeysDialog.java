package haltere.ui.viewer;

import atlantafx.base.theme.Styles;
import java.util.LinkedHashMap;
import java.util.Map;
import javafx.scene.control.Alert;
import javafx.scene.control.ButtonType;
import javafx.scene.control.Label;
import javafx.scene.layout.GridPane;
import javafx.stage.Window;

/**
 * Lists the keys.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class KeysDialog {
  private KeysDialog() {}

  static void show(Window owner) {
    Map<String, String> keys = new LinkedHashMap<>();
    keys.put("Space", "play, pause");
    keys.put(".  ,", "one slice on, back; with Shift 20");
    keys.put("F  S", "faster, slower by a fourth of an octave");
    keys.put("R", "back to the start");
    keys.put("\u2190  \u2192", "one second back, on; with Shift ten");
    keys.put("Home  End", "to the start, to the end");
    keys.put("I  O", "the loop's start, end");
    keys.put("L", "repeat at the end");
    keys.put("M", "set a mark");
    keys.put("J  K", "to the mark before, after");
    keys.put("Z", "let all filters forget");
    keys.put("Enter", "press the button that has the focus");
    keys.put("Wheel, drag", "zoom, move; double click shows all");
    keys.put("Ctrl+O", "open a recording; or drop one on the window");
    keys.put("Ctrl+Q", "quit");
    keys.put("F11", "full screen");
    GridPane grid = new GridPane();
    grid.setHgap(18);
    grid.setVgap(6);
    int row = 0;
    for (Map.Entry<String, String> key : keys.entrySet()) {
      Label name = new Label(key.getKey());
      name.getStyleClass().add(Styles.TEXT_BOLD);
      grid.addRow(row++, name, new Label(key.getValue()));
    }
    Alert alert = new Alert(Alert.AlertType.NONE, "", ButtonType.CLOSE);
    alert.setTitle("Keys");
    alert.getDialogPane().setContent(grid);
    alert.initOwner(owner);
    alert.show();
  }
}
