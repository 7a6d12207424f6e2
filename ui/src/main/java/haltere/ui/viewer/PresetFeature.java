package haltere.ui.viewer;

import haltere.core.chain.ChainFile;
import haltere.core.format.AtomicFile;
import haltere.ui.viewer.action.ViewerAction;
import haltere.ui.viewer.chain.ChainEditor;
import haltere.ui.viewer.chain.ChainPresets;
import haltere.ui.viewer.controls.Windows;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/**
 * Chains that a user keeps under a name: chain files in the folder {@code presets} beside the
 * settings, which can be copied there and given to others.
 *
 * <p>Thread rule: JavaFX thread only.
 */
public final class PresetFeature implements ViewerFeature, ChainPresets {
  private static final String MENU = "Chain/Presets";
  private static final String FOLDER = "presets";
  private static final String ENDING = ".json";

  private ViewerContext window;
  private Path folder;
  private List<String> names = List.of();

  @Override
  public void install(ViewerContext installed) {
    window = installed;
    window.actions().add("save-preset", () -> keep(window.editor()));
    window.editor().setPresets(this);
    window
        .settings()
        .file()
        .ifPresent(
            settings -> {
              folder = settings.resolveSibling(FOLDER);
              list();
            });
  }

  @Override
  public List<String> names() {
    return names;
  }

  @Override
  public void keep(ChainEditor chain) {
    Windows.ask(window.stage(), "Preset", "Name of the preset", "", name -> save(name, chain));
  }

  /** Keeps a chain under a name. */
  public void save(String name, ChainEditor chain) {
    if (folder == null || name.matches(".*[/\\\\:].*")) {
      window.status().showError("A preset cannot be named " + name);
      return;
    }
    chain.read(
        ChainFile::write,
        json -> window.file(() -> write(folder.resolve(name + ENDING), json), written -> list()));
  }

  private static Path write(Path file, String json) throws IOException {
    Files.createDirectories(file.getParent());
    AtomicFile.write(file, json, true);
    return file;
  }

  private void list() {
    window.file(() -> files(folder), this::offer);
  }

  private static List<Path> files(Path folder) throws IOException {
    if (!Files.isDirectory(folder)) {
      return List.of();
    }
    try (Stream<Path> files = Files.list(folder)) {
      return files.filter(file -> file.toString().endsWith(ENDING)).sorted().toList();
    }
  }

  private void offer(List<Path> files) {
    names = files.stream().map(PresetFeature::name).toList();
    window.actions().offer(FOLDER, names.stream().map(this::action).toList());
  }

  private ViewerAction action(String name) {
    return ViewerAction.of("preset-" + name, name, MENU, () -> load(name, window.editor()));
  }

  private static String name(Path file) {
    String name = file.getFileName().toString();
    return name.substring(0, name.length() - ENDING.length());
  }

  @Override
  public void load(String name, ChainEditor chain) {
    window.loadChain(folder.resolve(name + ENDING), chain);
  }
}
