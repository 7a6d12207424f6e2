package haltere.ui.viewer;

import haltere.core.chain.ChainFile;
import haltere.core.format.AtomicFile;
import haltere.ui.viewer.action.ViewerAction;
import haltere.ui.viewer.chain.ChainEditor;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.Windows;
import haltere.ui.viewer.feature.WindowFeature;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import javafx.scene.control.MenuItem;
import javafx.scene.control.SeparatorMenuItem;

/**
 * Saved chains by name: chain files in the folder {@code presets} beside the settings, which can be
 * copied.
 */
public final class PresetFeature extends WindowFeature {
  private static final String MENU = "Chain/Presets";
  private static final String FOLDER = "presets";
  private static final String ENDING = ".json";

  private Path folder;
  private List<String> names = List.of();

  @Override
  protected void install() {
    window.actions().add("save-preset", () -> keep(window.editor()), window::nothingOpen);
    window.editor().setPresets(this::items);
    folder = window.settings().file().map(file -> file.resolveSibling(FOLDER)).orElse(null);
    if (folder != null) {
      window.file(() -> read(folder), this::offer);
    }
  }

  /** Saved presets, by name. */
  public List<String> names() {
    return names;
  }

  /** A menu that saves a chain under a name, or replaces its filters by a saved one. */
  private List<MenuItem> items(String menu, ChainEditor chain) {
    List<MenuItem> items = new ArrayList<>();
    items.add(Controls.item(menu + "-keep", "Save as preset\u2026", () -> keep(chain)));
    if (!names.isEmpty()) {
      items.add(new SeparatorMenuItem());
    }
    names.forEach(
        name -> items.add(Controls.item(menu + "-" + name, name, () -> load(name, chain))));
    return items;
  }

  private void keep(ChainEditor chain) {
    Windows.askName(window.stage(), "preset", names, name -> save(name, chain));
  }

  /** Keeps a chain under a name. */
  public void save(String name, ChainEditor chain) {
    if (folder == null || name.matches(".*[/\\\\:].*")) {
      window.status().showRefusal(name + ": the name of a preset has no / \\ or :");
      return;
    }
    chain.read(ChainFile::write, json -> window.file(() -> write(name, json), this::offer));
  }

  private Map<String, String> write(String name, String json) throws IOException {
    Files.createDirectories(folder);
    AtomicFile.write(folder.resolve(name + ENDING), json, true);
    return read(folder);
  }

  /** Contents of the files by the names of the chains, in alphabetical order. */
  private static Map<String, String> read(Path folder) throws IOException {
    Map<String, String> kept = new TreeMap<>();
    if (Files.isDirectory(folder)) {
      try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, "*" + ENDING)) {
        for (Path file : files) {
          String name = file.getFileName().toString();
          // any bytes: an invalid file must not break the menu
          String json = Files.readString(file, StandardCharsets.ISO_8859_1);
          kept.put(name.substring(0, name.length() - ENDING.length()), json);
        }
      }
    }
    return kept;
  }

  private void offer(Map<String, String> kept) {
    names = List.copyOf(kept.keySet());
    window.editor().setPresetChains(kept);
    window.actions().offer(FOLDER, names.stream().map(this::action).toList());
  }

  private ViewerAction action(String name) {
    return ViewerAction.of("preset-" + name, name, MENU, () -> load(name, window.editor()));
  }

  private void load(String name, ChainEditor chain) {
    window.loadChain(folder.resolve(name + ENDING), chain);
  }
}
