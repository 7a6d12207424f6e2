package haltere.ui.viewer;

import haltere.core.format.RecordingFormat;
import haltere.core.format.Recordings;
import java.io.File;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.TreeSet;
import javafx.stage.FileChooser;
import javafx.stage.FileChooser.ExtensionFilter;
import javafx.stage.Window;

/**
 * Asks for files.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class FileDialogs {
  private final Window owner;
  private File folder;

  FileDialogs(Window owner) {
    this.owner = owner;
  }

  Optional<Path> recording() {
    TreeSet<String> endings = new TreeSet<>();
    for (RecordingFormat format : Recordings.formats().values()) {
      format.extensions().forEach(extension -> endings.add("*." + extension));
    }
    FileChooser chooser = chooser("Open recording");
    chooser
        .getExtensionFilters()
        .addAll(
            new ExtensionFilter("Recordings", List.copyOf(endings)),
            new ExtensionFilter("All files", "*"));
    return remembered(chooser.showOpenDialog(owner));
  }

  Optional<Path> chainToLoad() {
    FileChooser chooser = chooser("Load chain");
    chooser.getExtensionFilters().add(new ExtensionFilter("Chains", "*.json"));
    return remembered(chooser.showOpenDialog(owner));
  }

  Optional<Path> chainToSave() {
    FileChooser chooser = chooser("Save chain");
    chooser.getExtensionFilters().add(new ExtensionFilter("Chains", "*.json"));
    chooser.setInitialFileName("chain.json");
    return remembered(chooser.showSaveDialog(owner));
  }

  Optional<Path> picture() {
    FileChooser chooser = chooser("Save picture");
    chooser.getExtensionFilters().add(new ExtensionFilter("Pictures", "*.png"));
    chooser.setInitialFileName("haltere.png");
    return remembered(chooser.showSaveDialog(owner));
  }

  Optional<Path> recordingToWrite() {
    FileChooser chooser = chooser("Record to");
    chooser.getExtensionFilters().add(new ExtensionFilter("AEDAT-4", "*.aedat4"));
    chooser.setInitialFileName("recording.aedat4");
    return remembered(chooser.showSaveDialog(owner));
  }

  Optional<Path> film() {
    FileChooser chooser = chooser("Export film");
    chooser
        .getExtensionFilters()
        .addAll(new ExtensionFilter("Animated GIF", "*.gif"), new ExtensionFilter("MP4", "*.mp4"));
    chooser.setInitialFileName("haltere.gif");
    return remembered(chooser.showSaveDialog(owner));
  }

  Optional<Path> recordingToExport() {
    FileChooser chooser = chooser("Export recording");
    chooser.getExtensionFilters().add(new ExtensionFilter("All files", "*"));
    chooser.setInitialFileName("part.aedat4");
    return remembered(chooser.showSaveDialog(owner));
  }

  Optional<Path> table() {
    FileChooser chooser = chooser("Save plots as table");
    chooser.getExtensionFilters().add(new ExtensionFilter("Tables", "*.csv"));
    chooser.setInitialFileName("plots.csv");
    return remembered(chooser.showSaveDialog(owner));
  }

  Optional<Path> log() {
    FileChooser chooser = chooser("Log wings to");
    chooser.getExtensionFilters().add(new ExtensionFilter("Logs", "*.txt"));
    chooser.setInitialFileName("wings.txt");
    return remembered(chooser.showSaveDialog(owner));
  }

  Optional<Path> observations() {
    FileChooser chooser = chooser("Open observations of several cameras");
    chooser
        .getExtensionFilters()
        .addAll(
            new ExtensionFilter("Observations", "*.csv", "*.braidz"),
            new ExtensionFilter("All files", "*"));
    return remembered(chooser.showOpenDialog(owner));
  }

  Optional<Path> cameras() {
    FileChooser chooser = chooser("Open their cameras");
    chooser
        .getExtensionFilters()
        .addAll(
            new ExtensionFilter("Cameras", "*.json", "*.xml"),
            new ExtensionFilter("All files", "*"));
    return remembered(chooser.showOpenDialog(owner));
  }

  private FileChooser chooser(String title) {
    FileChooser chooser = new FileChooser();
    chooser.setTitle(title);
    if (folder != null && folder.isDirectory()) {
      chooser.setInitialDirectory(folder);
    }
    return chooser;
  }

  private Optional<Path> remembered(File chosen) {
    if (chosen == null) {
      return Optional.empty();
    }
    folder = chosen.getAbsoluteFile().getParentFile();
    return Optional.of(chosen.toPath());
  }
}
