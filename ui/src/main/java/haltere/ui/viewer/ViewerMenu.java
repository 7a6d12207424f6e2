package haltere.ui.viewer;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import javafx.beans.value.ChangeListener;
import javafx.beans.value.ObservableBooleanValue;
import javafx.beans.value.WeakChangeListener;
import javafx.scene.control.CheckMenuItem;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuBar;
import javafx.scene.control.MenuItem;
import javafx.scene.input.KeyCombination;

/**
 * The menus, made from the actions that there are.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class ViewerMenu extends MenuBar {
  private static final List<String> ORDER =
      List.of("File", "Edit", "View", "Playback", "Chain", "Tools", "Camera");
  private static final String LAST = "Help";

  private final ViewerActions actions;

  ViewerMenu(ViewerActions actions) {
    this.actions = actions;
    setId("menu");
  }

  /** Shows the actions that there are, and from now on every change of them. */
  void follow() {
    actions.onChange(this::fill);
    fill();
  }

  private void fill() {
    Map<String, Menu> menus = new LinkedHashMap<>();
    ORDER.forEach(words -> menus.put(words, new Menu("_" + words)));
    for (ViewerAction action : actions.all()) {
      if (!action.menu().isEmpty()) {
        menu(menus, action.menu()).getItems().add(item(action));
      }
    }
    Menu last = menus.remove(LAST);
    getMenus()
        .setAll(
            menus.entrySet().stream()
                .filter(entry -> !entry.getKey().contains("/"))
                .map(Map.Entry::getValue)
                .filter(menu -> !menu.getItems().isEmpty())
                .toList());
    if (last != null) {
      getMenus().add(last);
    }
  }

  /** The menu of a path, made with those above it if it is not there yet. */
  private static Menu menu(Map<String, Menu> menus, String path) {
    Menu there = menus.get(path);
    if (there != null) {
      return there;
    }
    int slash = path.lastIndexOf('/');
    Menu made = new Menu(slash < 0 ? "_" + path : path.substring(slash + 1));
    if (slash >= 0) {
      menu(menus, path.substring(0, slash)).getItems().add(made);
    }
    menus.put(path, made);
    return made;
  }

  private static MenuItem item(ViewerAction action) {
    MenuItem item =
        action.on().<MenuItem>map(on -> check(action, on)).orElseGet(() -> plain(action));
    item.setId(action.id());
    if (action.hasPlainKey()) {
      // no accelerator, which would fire while text is entered: ViewerKeys knows the key
      item.setText(action.words() + "   (" + ViewerKeys.words(action.key()) + ")");
    } else if (!action.key().isEmpty()) {
      item.setAccelerator(KeyCombination.keyCombination(action.key()));
    }
    return item;
  }

  private static MenuItem plain(ViewerAction action) {
    MenuItem item = new MenuItem(action.words());
    item.setMnemonicParsing(false);
    item.setOnAction(event -> action.work().run());
    return item;
  }

  private static MenuItem check(ViewerAction action, ObservableBooleanValue on) {
    CheckMenuItem item = new CheckMenuItem(action.words());
    item.setMnemonicParsing(false);
    item.setSelected(on.get());
    ChangeListener<Boolean> shower = (property, was, is) -> item.setSelected(is);
    // the listener lives as long as the item, which later ones replace
    item.getProperties().put(ViewerMenu.class, shower);
    on.addListener(new WeakChangeListener<>(shower));
    item.setOnAction(
        event -> {
          action.work().run();
          item.setSelected(on.get());
        });
    return item;
  }
}
