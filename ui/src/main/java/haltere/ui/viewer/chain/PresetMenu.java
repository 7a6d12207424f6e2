package haltere.ui.viewer.chain;

import haltere.ui.viewer.controls.Controls;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;

/** Keeps a chain inside the chain as a preset, or puts a preset in its place. */
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
    items.add(item("keep", "Save as preset\u2026", presets -> presets.keep(chain)));
    List<String> names = chain.presets().map(ChainPresets::names).orElse(List.of());
    if (!names.isEmpty()) {
      items.add(new SeparatorMenuItem());
    }
    for (String name : names) {
      items.add(item(name, name, presets -> presets.load(name, chain)));
    }
    getItems().setAll(items);
  }

  private MenuItem item(String end, String words, Consumer<ChainPresets> work) {
    return Controls.item(getId() + "-" + end, words, () -> chain.presets().ifPresent(work));
  }
}
