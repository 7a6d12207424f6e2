package haltere.ui.viewer.chain;

import atlantafx.base.theme.Styles;
import haltere.core.chain.FilterProvider;
import haltere.core.chain.Filters;
import haltere.core.extension.Extensions;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.Icons;
import haltere.ui.viewer.controls.Texts;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javafx.scene.control.CustomMenuItem;
import javafx.scene.control.Label;
import javafx.scene.control.MenuButton;
import javafx.scene.control.MenuItem;
import javafx.scene.control.TextField;
import javafx.scene.input.KeyEvent;
import javafx.scene.layout.VBox;

/**
 * A menu of all filters that can be added to a chain, and of a nested chain, with descriptions and
 * a search.
 */
final class AddFilterMenu extends MenuButton {
  /** A menu with an id and a help text; the id of its search adds "-search". */
  AddFilterMenu(String id, String help, ChainEditor editor) {
    super("Add", Icons.ADD.node());
    setId(id);
    setAccessibleText(help);
    Controls.help(this, help);
    getStyleClass().addAll(Styles.SMALL, Styles.FLAT);
    TextField wanted = Controls.named(new TextField(), id + "-search");
    wanted.setPromptText("Search filters");
    wanted.setAccessibleText("Search filters");
    List<Item> items = new ArrayList<>();
    for (FilterProvider<?> found : Filters.all().values()) {
      items.add(new Item(found.name(), found.description(), () -> editor.add(found)));
    }
    items.add(
        new Item(
            "chain",
            "Filters of its own, which are switched on and off and measured together.",
            editor::addChain));
    wanted.textProperty().subscribe((was, is) -> items.forEach(item -> item.narrow(is)));
    wanted.setOnAction(
        event -> {
          // Enter adds the first match
          items.stream().filter(MenuItem::isVisible).findFirst().ifPresent(MenuItem::fire);
          hide();
        });
    setOnShown(
        event -> {
          wanted.clear();
          wanted.requestFocus();
          // the mouse gives the focus to the filter below it
          wanted.getScene().setOnKeyTyped(typed -> search(wanted, typed));
        });
    getItems().add(new CustomMenuItem(wanted, false));
    for (String problem : Extensions.problems()) {
      Label why = Controls.named(Controls.paragraph(problem, "problem"), "extension-problem");
      why.setMaxWidth(300);
      getItems().add(new CustomMenuItem(new VBox(why)));
    }
    getItems().addAll(items);
  }

  private static void search(TextField wanted, KeyEvent typed) {
    if (!wanted.isFocused()) {
      wanted.requestFocus();
      wanted.fireEvent(typed);
    }
  }

  /** A filter with its description. */
  private static final class Item extends CustomMenuItem {
    private final String text;

    Item(String name, String description, Runnable add) {
      text = (Texts.title(name) + " " + description).toLowerCase(Locale.ROOT);
      Label title = Controls.label(Texts.title(name), Styles.TEXT_BOLD);
      Label help = Controls.paragraph(description, Styles.TEXT_SMALL, Styles.TEXT_MUTED);
      help.setMaxWidth(300);
      setContent(new VBox(2, title, help));
      setId("add-" + name);
      setOnAction(event -> add.run());
    }

    void narrow(String wanted) {
      setVisible(text.contains(wanted.strip().toLowerCase(Locale.ROOT)));
    }
  }
}
