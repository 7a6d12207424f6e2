package haltere.ui.viewer.chain;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;

/**
 * Keeps a chain inside the chain as a preset, or puts a preset in its place.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class PresetMenu extends Menu {
  private final ChainEditor chain;

  /** A menu for the filters of a chain; the id of its first item adds "-keep". */
  PresetMenu(String id, ChainEditor chain) {
    super("Presets");
    this.chain = chain;
    setId(id);
    // a menu without items never opens
    follow();
    setOnShowing(event -> follow());
  }

  private void follow() {
    List<MenuItem> items = new ArrayList<>();
    MenuItem keep = item("Save as preset\u2026", presets -> presets.keep(chain));
    keep.setId(getId() + "-keep");
    items.add(keep);
    List<String> names = chain.presets().map(ChainPresets::names).orElse(List.of());
    if (!names.isEmpty()) {
      items.add(new SeparatorMenuItem());
    }
    for (String name : names) {
      MenuItem load = item(name, presets -> presets.load(name, chain));
      load.setId(getId() + "-" + name);
      items.add(load);
    }
    getItems().setAll(items);
  }

  private MenuItem item(String words, Consumer<ChainPresets> work) {
    MenuItem item = new MenuItem(words);
    item.setOnAction(event -> chain.presets().ifPresent(work));
    return item;
  }
}
