package haltere.ui.viewer;

import atlantafx.base.theme.Styles;
import javafx.geometry.Insets;
import javafx.scene.control.Alert;
import javafx.scene.control.ButtonType;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.layout.GridPane;
import javafx.stage.Window;

/**
 * Lists the keys.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class KeysDialog {
  private KeysDialog() {}

  static void show(Window owner, ViewerActions actions) {
    GridPane grid = new GridPane();
    grid.setHgap(18);
    grid.setVgap(4);
    grid.setPadding(new Insets(12));
    int row = 0;
    String menu = "";
    for (ViewerAction action : actions.all()) {
      if (action.key().isEmpty()) {
        continue;
      }
      String own = action.menu().isEmpty() ? "Other" : action.menu();
      if (!own.equals(menu)) {
        menu = own;
        Label heading = new Label(menu.replace("/", " > "));
        heading.getStyleClass().add(Styles.TEXT_MUTED);
        grid.add(heading, 0, row++, 2, 1);
      }
      row = add(grid, row, ViewerKeys.words(action.key()), action.words());
    }
    row = add(grid, row, "Enter", "Press the button that has the focus");
    add(grid, row, "Wheel, drag", "Zoom, move; a double click shows all");
    ScrollPane scroll = new ScrollPane(grid);
    scroll.setPrefViewportHeight(520);
    scroll.setFitToWidth(true);
    Alert alert = new Alert(Alert.AlertType.NONE, "", ButtonType.CLOSE);
    alert.setTitle("Keys");
    alert.getDialogPane().setContent(scroll);
    alert.initOwner(owner);
    alert.show();
  }

  private static int add(GridPane grid, int row, String key, String words) {
    Label name = new Label(key);
    name.getStyleClass().add(Styles.TEXT_BOLD);
    name.setMinWidth(110);
    grid.addRow(row, name, new Label(words));
    return row + 1;
  }
}
