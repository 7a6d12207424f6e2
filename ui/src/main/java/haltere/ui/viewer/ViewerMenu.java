package haltere.ui.viewer;

import haltere.ui.rendering.ColourMap;
import java.util.LinkedHashMap;
import java.util.Map;
import javafx.scene.control.CheckMenuItem;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuBar;
import javafx.scene.control.MenuItem;
import javafx.scene.control.RadioMenuItem;
import javafx.scene.control.SeparatorMenuItem;
import javafx.scene.control.ToggleGroup;
import javafx.scene.input.KeyCombination;

/**
 * The menus. They know no more than what to call.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class ViewerMenu extends MenuBar {
  /** What the menus can ask of the window. */
  interface Actions {
    void openFile();

    void openScene();

    void loadChain();

    void saveChain();

    void savePicture();

    void toggleRecording();

    void quit();

    void toggleFullScreen();

    void showAll();

    void setTheme(Theme theme);

    void setColours(ColourMap colours);

    void setDecay(long decayUs);

    void setMarksVisible(boolean visible);

    void setPlotsVisible(boolean visible);

    void savePlotTable();

    void savePlotPicture();

    void showKeys();
  }

  private final MenuItem record = new MenuItem("Record\u2026");
  private final CheckMenuItem plots = new CheckMenuItem("Plots");
  private final Map<ColourMap, RadioMenuItem> colourItems = new LinkedHashMap<>();

  ViewerMenu(Actions actions, PlaybackController playback) {
    setId("menu");
    getMenus()
        .addAll(
            file(actions),
            view(actions),
            playback(playback),
            new Menu("_Help", null, help(actions)));
  }

  /** Shows whether a recording is under way. */
  void showRecording(boolean under) {
    record.setText(under ? "Stop recording" : "Record\u2026");
  }

  /** Shows that the plots are open. */
  void showPlots() {
    plots.setSelected(true);
  }

  /** Shows which colours are in use. */
  void showColours(ColourMap colours) {
    colourItems.get(colours).setSelected(true);
  }

  private Menu file(Actions actions) {
    record.setId("record");
    record.setAccelerator(KeyCombination.keyCombination("Shortcut+E"));
    record.setOnAction(event -> actions.toggleRecording());
    return new Menu(
        "_File",
        null,
        item("open", "Open recording\u2026", "Shortcut+O", actions::openFile),
        item("open-scene", "Open the fly scene", "", actions::openScene),
        new SeparatorMenuItem(),
        item("load-chain", "Load chain\u2026", "Shortcut+L", actions::loadChain),
        item("save-chain", "Save chain\u2026", "Shortcut+S", actions::saveChain),
        record,
        item("save-picture", "Save picture\u2026", "Shortcut+P", actions::savePicture),
        item("save-plot-table", "Save plots as table\u2026", "", actions::savePlotTable),
        item("save-plot-picture", "Save plots as picture\u2026", "", actions::savePlotPicture),
        new SeparatorMenuItem(),
        item("quit", "Quit", "Shortcut+Q", actions::quit));
  }

  private Menu view(Actions actions) {
    Menu theme = new Menu("Theme");
    ToggleGroup themes = new ToggleGroup();
    for (Theme choice : Theme.values()) {
      theme
          .getItems()
          .add(radio(themes, choice.words(), choice == Theme.DARK, () -> actions.setTheme(choice)));
    }
    Menu colours = new Menu("Colours of events");
    ToggleGroup maps = new ToggleGroup();
    for (ColourMap map : ColourMap.all()) {
      RadioMenuItem item =
          radio(maps, map.name(), map == ColourMap.DARK, () -> actions.setColours(map));
      colourItems.put(map, item);
      colours.getItems().add(item);
    }
    Menu decay = new Menu("Fading");
    ToggleGroup times = new ToggleGroup();
    Map<String, Long> choices = new LinkedHashMap<>();
    choices.put("Follows the speed", DisplayOptions.FOLLOW_SLICES);
    for (long us : new long[] {100, 300, 1000, 3000, 10_000, 30_000, 100_000, 300_000}) {
      choices.put(Texts.duration(us), us);
    }
    choices.forEach(
        (words, us) ->
            decay
                .getItems()
                .add(
                    radio(
                        times,
                        words,
                        us == DisplayOptions.FOLLOW_SLICES,
                        () -> actions.setDecay(us))));
    CheckMenuItem marks = new CheckMenuItem("Overlays");
    marks.setId("overlays");
    marks.setSelected(true);
    marks.setOnAction(event -> actions.setMarksVisible(marks.isSelected()));
    plots.setId("show-plots");
    plots.setAccelerator(KeyCombination.keyCombination("Shortcut+G"));
    plots.setOnAction(event -> actions.setPlotsVisible(plots.isSelected()));
    return new Menu(
        "_View",
        null,
        theme,
        colours,
        decay,
        marks,
        plots,
        new SeparatorMenuItem(),
        item("show-all", "Whole sensor", "Shortcut+0", actions::showAll),
        item("full-screen", "Full screen", "F11", actions::toggleFullScreen));
  }

  private static Menu playback(PlaybackController playback) {
    return new Menu(
        "_Playback",
        null,
        item("clear-in-out", "Clear the loop's start and end", "", playback::clearInOut),
        item("clear-marks", "Clear all marks", "", playback::clearMarks),
        new SeparatorMenuItem(),
        item("menu-reset", "Reset all filters", "Shortcut+R", playback::reset));
  }

  private static MenuItem help(Actions actions) {
    return item("keys", "Keys", "F1", actions::showKeys);
  }

  private static MenuItem item(String id, String words, String key, Runnable action) {
    MenuItem item = new MenuItem(words);
    item.setId(id);
    if (!key.isEmpty()) {
      item.setAccelerator(KeyCombination.keyCombination(key));
    }
    item.setOnAction(event -> action.run());
    return item;
  }

  private static RadioMenuItem radio(
      ToggleGroup group, String words, boolean selected, Runnable action) {
    RadioMenuItem item = new RadioMenuItem(words);
    item.setToggleGroup(group);
    item.setSelected(selected);
    item.setOnAction(event -> action.run());
    return item;
  }
}
