package haltere.ui.viewer.action;

import haltere.ui.viewer.controls.Controls;
import java.util.ArrayList;
import java.util.HashMap;
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
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.input.KeyCombination;
import javafx.scene.input.KeyEvent;

/** The menus, built from the commands. */
public final class ViewerMenu extends MenuBar {
  private static final List<String> ORDER =
      List.of("File", "Edit", "View", "Playback", "Chain", "Tools", "Camera", "Wings", "Help");

  private final ViewerActions actions;
  private final Map<String, Menu> menus = new HashMap<>();

  /** Items of each menu by path, in order: actions, and paths of submenus. */
  private Map<String, List<Object>> shown = Map.of();

  /** A menu that is empty until it {@link #follow follows} the actions. */
  public ViewerMenu(ViewerActions actions) {
    this.actions = actions;
    setId("menu");
  }

  /** Place in the bar of the menu that an action is in; the last one for none. */
  static int place(ViewerAction action) {
    int place = ORDER.indexOf(action.menu().split("/")[0]);
    return place < 0 ? ORDER.size() : place;
  }

  /** Shows the actions, and later changes of them. */
  public void follow() {
    actions.onChange(this::fill);
    fill();
  }

  /** Rebuilds only menus whose actions have changed: building a menu takes milliseconds. */
  private void fill() {
    Map<String, List<Object>> contents = new LinkedHashMap<>();
    ORDER.forEach(path -> contents.put(path, new ArrayList<>()));
    for (ViewerAction action : actions.all()) {
      if (!action.menu().isEmpty()) {
        contents(contents, action.menu()).add(action);
      }
    }
    menus.keySet().retainAll(contents.keySet());
    contents.forEach(
        (path, content) -> {
          if (!content.equals(shown.get(path))) {
            menu(path).getItems().setAll(items(content));
          }
        });
    shown = contents;
    fillBar(contents);
  }

  /** The items of a menu, with a line between groups of actions. */
  private List<MenuItem> items(List<Object> content) {
    List<MenuItem> items = new ArrayList<>();
    int last = -1;
    for (Object one : content) {
      int group = one instanceof ViewerAction action ? ActionTable.group(action.id(), last) : last;
      if (last >= 0 && group != last) {
        items.add(new SeparatorMenuItem());
      }
      last = group;
      items.add(one instanceof ViewerAction action ? item(action) : menu(one));
    }
    return items;
  }

  /** Says of each action in a menu that opens whether it can be done, and why not. */
  private static void showObstacles(Menu menu) {
    for (MenuItem item : menu.getItems()) {
      if (item.getProperties().get(ViewerAction.class) instanceof ViewerAction action) {
        String obstacle = action.obstacle().get();
        item.setDisable(!obstacle.isEmpty());
        item.setText(action.label() + (obstacle.isEmpty() ? "" : "  (" + obstacle + ")"));
      }
    }
  }

  private void fillBar(Map<String, List<Object>> contents) {
    List<Menu> bar =
        ORDER.stream().filter(path -> !contents.get(path).isEmpty()).map(this::menu).toList();
    if (!bar.equals(getMenus())) {
      getMenus().setAll(bar);
    }
  }

  /** Items of a menu: actions, and paths of submenus, which are created on the way. */
  private static List<Object> contents(Map<String, List<Object>> contents, String path) {
    List<Object> there = contents.get(path);
    if (there != null) {
      return there;
    }
    int slash = path.lastIndexOf('/');
    if (slash >= 0) {
      contents(contents, path.substring(0, slash)).add(path);
    }
    List<Object> made = new ArrayList<>();
    contents.put(path, made);
    return made;
  }

  private Menu menu(Object path) {
    String whole = path.toString();
    int slash = whole.lastIndexOf('/');
    return menus.computeIfAbsent(
        whole,
        made -> {
          Menu menu = new Menu(slash < 0 ? "_" + whole : whole.substring(slash + 1));
          menu.setOnShowing(event -> showObstacles(menu));
          // a key must reach what can be done by then
          menu.setOnHidden(event -> menu.getItems().forEach(item -> item.setDisable(false)));
          return menu;
        });
  }

  private MenuItem item(ViewerAction action) {
    MenuItem item =
        action
            .on()
            .<MenuItem>map(on -> check(action, on))
            .orElseGet(() -> Controls.item(action.id(), action.label(), () -> actions.run(action)));
    item.getProperties().put(ViewerAction.class, action);
    if (action.hasPlainKey()) {
      item.setAccelerator(new ShownKey(ViewerKeys.label(action.key())));
    } else if (!action.key().isEmpty()) {
      item.setAccelerator(KeyCombination.keyCombination(action.key()));
    }
    return item;
  }

  /**
   * A key in the menu's column of keys that fires nothing, because it would do so while text is
   * entered: {@link ViewerKeys} knows it.
   */
  private static final class ShownKey extends KeyCombination {
    private final String text;

    ShownKey(String text) {
      this.text = text;
    }

    @Override
    public boolean match(KeyEvent event) {
      return false;
    }

    @Override
    public String getDisplayText() {
      return text;
    }

    // those of KeyCombination compare modifiers only, and no shown key has any
    @Override
    public boolean equals(Object other) {
      return other == this;
    }

    @Override
    public int hashCode() {
      return System.identityHashCode(this);
    }
  }

  private MenuItem check(ViewerAction action, ObservableBooleanValue on) {
    CheckMenuItem item = new CheckMenuItem(action.label());
    item.setId(action.id());
    item.setMnemonicParsing(false);
    item.setSelected(on.get());
    ChangeListener<Boolean> shower = (property, was, is) -> item.setSelected(is);
    // the listener lives as long as the item, which later items replace
    item.getProperties().put(ViewerMenu.class, shower);
    on.addListener(new WeakChangeListener<>(shower));
    item.setOnAction(
        event -> {
          actions.run(action);
          item.setSelected(on.get());
        });
    return item;
  }
}
