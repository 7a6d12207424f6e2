package haltere.ui.viewer.action;

import atlantafx.base.theme.Styles;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.Windows;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import javafx.geometry.Insets;
import javafx.scene.control.Label;
import javafx.scene.control.ScrollPane;
import javafx.scene.layout.GridPane;
import javafx.stage.Window;

/** Lists the keys. */
public final class KeysDialog {
  private static final List<Map.Entry<String, String>> OTHERS =
      List.of(
          Map.entry("Tab, Enter", "To the next control; press it, or open its list"),
          Map.entry("Arrows, Enter", "With a tool: move it, press and release it"),
          Map.entry("Arrows, +, \u2212, End", "In plots and in space: move, zoom, show the newest"),
          Map.entry("Ctrl+Shift+\u2191, \u2193", "Move the filter that has the focus up or down"),
          Map.entry("Wheel, drag", "Zoom, move; a double click shows all"));

  private KeysDialog() {}

  /** Opens the list of keys over a window and returns at once. */
  public static void show(Window owner, ViewerActions actions) {
    GridPane grid = new GridPane(18, 4);
    grid.setPadding(new Insets(12));
    List<ViewerAction> keyed =
        actions.all().stream()
            .filter(action -> !action.key().isEmpty())
            .sorted(Comparator.comparingInt(ViewerMenu::place).thenComparing(ViewerAction::menu))
            .toList();
    String menu = null;
    for (ViewerAction action : keyed) {
      if (!action.menu().equals(menu)) {
        menu = action.menu();
        String name = menu.isEmpty() ? "Other" : menu.replace("/", " > ");
        grid.add(Controls.label(name, Styles.TEXT_MUTED), 0, grid.getRowCount(), 2, 1);
      }
      add(grid, ViewerKeys.label(action.key()), action.label());
    }
    for (Map.Entry<String, String> other : OTHERS) {
      add(grid, other.getKey(), other.getValue());
    }
    ScrollPane scroll = Controls.scrolling(grid);
    scroll.setPrefViewportHeight(520);
    scroll.setFocusTraversable(true);
    scroll.setAccessibleText("Keys and their commands");
    Windows.showContent(owner, "Keys", scroll);
  }

  private static void add(GridPane grid, String key, String text) {
    Label name = Controls.label(key, Styles.TEXT_BOLD);
    name.setMinWidth(110);
    grid.addRow(grid.getRowCount(), name, new Label(text));
  }
}
