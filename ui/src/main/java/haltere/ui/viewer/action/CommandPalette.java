package haltere.ui.viewer.action;

import atlantafx.base.theme.Styles;
import haltere.ui.viewer.controls.Controls;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import javafx.scene.layout.VBox;
import javafx.stage.Popup;
import javafx.stage.Stage;
import javafx.stage.Window;

/**
 * All commands in a list with a search. Enter or a click runs the selected one, Escape closes it.
 */
public final class CommandPalette {
  private static final double WIDTH = 520;

  private final Stage stage;
  private final ViewerActions actions;
  private final TextField search = Controls.named(new TextField(), "palette-search");
  private final ListView<ViewerAction> list =
      Controls.named(new ListView<ViewerAction>(), "palette-list");
  private final Popup popup = new Popup();

  /** A palette of actions over a window, not shown yet. */
  public CommandPalette(Stage stage, ViewerActions actions) {
    this.stage = stage;
    this.actions = actions;
  }

  /** Opens it in the window's middle, with nothing searched for. */
  public void show() {
    if (popup.getContent().isEmpty()) {
      build();
    }
    search.clear();
    filter("");
    // the plots may have a window of their own; a tooltip is focused with its window
    Window over =
        Window.getWindows().stream()
            .filter(other -> other instanceof Stage && other != stage && other.isFocused())
            .findFirst()
            .orElse(stage);
    popup.show(over, over.getX() + (over.getWidth() - WIDTH) / 2, over.getY() + 90);
    search.requestFocus();
  }

  private void build() {
    search.setPromptText("What do you want to do?");
    search.setAccessibleText("Search commands");
    search.textProperty().subscribe((was, is) -> filter(is));
    list.setAccessibleText("Commands");
    list.setPrefSize(WIDTH, 380);
    list.setFixedCellSize(34);
    list.setFocusTraversable(false);
    list.setPlaceholder(new Label("No command matches."));
    list.setCellFactory(view -> new Cell());
    list.setOnMouseClicked(event -> choose());
    VBox box = new VBox(6, search, list);
    box.getStyleClass().addAll("palette");
    box.getStylesheets().addAll(stage.getScene().getStylesheets());
    box.addEventFilter(KeyEvent.KEY_PRESSED, this::pressed);
    popup.getContent().add(box);
    popup.setAutoHide(true);
  }

  private void pressed(KeyEvent event) {
    KeyCode code = event.getCode();
    if (code == KeyCode.ENTER) {
      choose();
    } else if (code == KeyCode.DOWN || code == KeyCode.UP) {
      int next = list.getSelectionModel().getSelectedIndex() + (code == KeyCode.DOWN ? 1 : -1);
      list.getSelectionModel().select(Math.max(0, next));
      list.scrollTo(Math.max(0, list.getSelectionModel().getSelectedIndex() - 4));
    } else if (code == KeyCode.ESCAPE) {
      popup.hide();
    } else {
      return;
    }
    event.consume();
  }

  private void filter(String typed) {
    list.getItems().setAll(matches(actions.all(), typed));
    list.getSelectionModel().selectFirst();
  }

  /**
   * The actions whose text contains all typed words, in any order; those that start with the typed
   * text come first, and those that are only described by it last.
   */
  static List<ViewerAction> matches(List<ViewerAction> all, String typed) {
    String wanted = typed.strip().toLowerCase(Locale.ROOT);
    List<String> parts = List.of(wanted.split("\\s+"));
    return all.stream()
        .filter(action -> !action.id().equals("palette"))
        .filter(action -> parts.stream().allMatch(words(action, action.help())::contains))
        .sorted(
            Comparator.comparing((ViewerAction action) -> !words(action, "").startsWith(wanted))
                .thenComparing(action -> !parts.stream().allMatch(words(action, "")::contains)))
        .toList();
  }

  private static String words(ViewerAction action, String more) {
    return (action.label() + " " + action.menu() + " " + more).toLowerCase(Locale.ROOT);
  }

  private void choose() {
    ViewerAction chosen = list.getSelectionModel().getSelectedItem();
    popup.hide();
    if (chosen != null) {
      actions.run(chosen);
    }
  }

  /** A line of the list: menu, name and key of the command. */
  private static final class Cell extends ListCell<ViewerAction> {
    private final Label menu = Controls.label("", Styles.TEXT_SMALL, Styles.TEXT_MUTED);
    private final Label text = new Label();
    private final Label key = Controls.label("", Styles.TEXT_SMALL, Styles.TEXT_MUTED);
    private final HBox line = Controls.row(10, text, menu, Controls.growing(new Region()), key);

    @Override
    protected void updateItem(ViewerAction action, boolean empty) {
      super.updateItem(action, empty);
      setText(null);
      setGraphic(empty ? null : line);
      if (!empty) {
        boolean on = action.on().isPresent() && action.on().get().get();
        text.setText((on ? "\u2713 " : "") + action.label());
        String obstacle = action.obstacle().get();
        line.setDisable(!obstacle.isEmpty());
        menu.setText(obstacle.isEmpty() ? action.menu().replace("/", " > ") : obstacle);
        key.setText(ViewerKeys.label(action.key()));
      }
    }
  }
}
