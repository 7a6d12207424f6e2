package haltere.ui.viewer.plots;

import haltere.ui.plot.PlotField;
import haltere.ui.plot.PlotSet;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.Texts;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;

/** Menus of plottable fields: a menu for each stage and outlet, an item for each column. */
final class PlotMenu {
  private PlotMenu() {}

  /** Sets of related plots, with a separator below them; empty without sets. */
  static List<MenuItem> sets(List<PlotField> fields, Consumer<PlotSet> chosen) {
    List<MenuItem> items = new ArrayList<>();
    for (PlotSet set : PlotSet.of(fields)) {
      String text = Texts.title(set.stage()) + ": " + set.title();
      items.add(Controls.item(null, text, () -> chosen.accept(set)));
    }
    if (!items.isEmpty()) {
      items.add(new SeparatorMenuItem());
    }
    return items;
  }

  static List<MenuItem> items(List<PlotField> fields, Consumer<PlotField> chosen) {
    List<MenuItem> items = new ArrayList<>();
    items.add(item("Event rate", PlotField.EVENT_RATE, chosen));
    Menu menu = null;
    for (PlotField field : fields) {
      String name = Texts.title(field.stage()) + ": " + field.outlet().replace('-', ' ');
      if (menu == null || !menu.getText().equals(name)) {
        menu = new Menu(name);
        items.add(menu);
      }
      menu.getItems().add(item(label(field), field, chosen));
    }
    return items;
  }

  private static String label(PlotField field) {
    String unit = field.unit();
    return Texts.title(field.label()) + (unit.isEmpty() ? "" : " (" + unit + ")");
  }

  private static MenuItem item(String text, PlotField field, Consumer<PlotField> chosen) {
    String id = "plot-" + field.toString().replace(" / ", "-");
    return Controls.item(id, text, () -> chosen.accept(field));
  }
}
