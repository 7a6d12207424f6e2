package haltere.ui.viewer.controls;

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
public final class FileDialogs {
  private static final ExtensionFilter ALL_FILES = new ExtensionFilter("All files", "*");
  private static final ExtensionFilter CHAINS = new ExtensionFilter("Chains", "*.json");

  private final Window owner;
  private File folder;

  /** Dialogs that belong to a window, which waits while one is open. */
  public FileDialogs(Window owner) {
    this.owner = owner;
  }

  /** A recording to be read. */
  public Optional<Path> recording() {
    TreeSet<String> endings = new TreeSet<>();
    for (RecordingFormat format : Recordings.formats().values()) {
      format.extensions().forEach(extension -> endings.add("*." + extension));
    }
    return open(
        "Open recording", new ExtensionFilter("Recordings", List.copyOf(endings)), ALL_FILES);
  }

  /** A chain to be read. */
  public Optional<Path> chainToLoad() {
    return open("Load chain", CHAINS);
  }

  /** Where a chain is to be written. */
  public Optional<Path> chainToSave() {
    return save("Save chain", "chain.json", CHAINS);
  }

  /** Where a picture is to be written. */
  public Optional<Path> picture() {
    return save("Save picture", "haltere.png", new ExtensionFilter("Pictures", "*.png"));
  }

  /** Where a recording is to be written. */
  public Optional<Path> recordingToWrite() {
    return save("Record to", "recording.aedat4", new ExtensionFilter("AEDAT-4", "*.aedat4"));
  }

  /** Where a film is to be written. */
  public Optional<Path> film() {
    return save("Export film", "haltere.gif", new ExtensionFilter("Films", "*.gif", "*.mp4"));
  }

  /** Where events that a chain left are to be written. */
  public Optional<Path> recordingToExport() {
    return save("Export recording", "part.aedat4", ALL_FILES);
  }

  /** Where numbers, or a picture of plots, are to be written. */
  public Optional<Path> table() {
    return save("Save plots as table", "plots.csv", new ExtensionFilter("Tables", "*.csv"));
  }

  /** Where a log of wings is to be written. */
  public Optional<Path> log() {
    return save("Log wings to", "wings.txt", new ExtensionFilter("Logs", "*.txt"));
  }

  /** What several cameras saw of a body, to be read. */
  public Optional<Path> observations() {
    return open(
        "Open observations of several cameras",
        new ExtensionFilter("Observations", "*.csv", "*.braidz", "*.h5", "*.hdf5"),
        ALL_FILES);
  }

  /** A file with several cameras and where they stand, to be read. */
  public Optional<Path> cameras() {
    return open("Open their cameras", new ExtensionFilter("Cameras", "*.json", "*.xml"), ALL_FILES);
  }

  private Optional<Path> open(String title, ExtensionFilter... filters) {
    FileChooser chooser = chooser(title);
    chooser.getExtensionFilters().addAll(filters);
    return remembered(chooser.showOpenDialog(owner));
  }

  private Optional<Path> save(String title, String name, ExtensionFilter... filters) {
    FileChooser chooser = chooser(title);
    chooser.getExtensionFilters().addAll(filters);
    chooser.setInitialFileName(name);
    return remembered(chooser.showSaveDialog(owner));
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
