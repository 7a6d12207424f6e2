package haltere.ui.viewer.controls;

import haltere.core.format.RecordingFormat;
import haltere.core.format.Recordings;
import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javafx.stage.FileChooser;
import javafx.stage.FileChooser.ExtensionFilter;
import javafx.stage.Window;

/** File dialogs. */
public final class FileDialogs {
  private static final ExtensionFilter ALL_FILES = new ExtensionFilter("All files", "*");

  private final Window owner;
  private File folder;
  private String source = "";

  /** Dialogs that belong to a window, which waits while one is open. */
  public FileDialogs(Window owner) {
    this.owner = owner;
  }

  /** Sets what is open, with which names of files to write begin. */
  public void setSource(String name) {
    source = name.replaceFirst("\\.\\w+$", "").replaceAll("\\W+", "-") + "-";
  }

  /** A recording to be read. */
  public Optional<Path> recording() {
    return open("Open recording", "Recordings", endings(format -> true));
  }

  /** Asks for the file of a recording in any format that can be written. */
  public Optional<Path> newRecording() {
    return save(
        "Export recording", "part.aedat4", "Recordings", endings(RecordingFormat::writable));
  }

  private static String[] endings(Predicate<RecordingFormat> wanted) {
    return Recordings.formats().values().stream()
        .filter(wanted)
        .flatMap(format -> format.extensions().stream())
        .map(extension -> "*." + extension)
        .distinct()
        .sorted()
        .toArray(String[]::new);
  }

  /** Asks for the file of a picture. */
  public Optional<Path> picture() {
    return save("Save picture", "picture.png", "Pictures", "*.png");
  }

  /** Asks for a file of several calibrated cameras. */
  public Optional<Path> cameras() {
    return open("Open calibrated cameras", "Cameras", "*.json", "*.xml");
  }

  /** Asks for a file to read, with the name and the extensions of its kind, or any other. */
  public Optional<Path> open(String title, String kind, String... endings) {
    FileChooser chooser = chooser(title);
    chooser.getExtensionFilters().addAll(new ExtensionFilter(kind, endings), ALL_FILES);
    return withFolder(chooser.showOpenDialog(owner));
  }

  /** Asks for a file to write, with a default name, and the name and the extensions of its kind. */
  public Optional<Path> save(String title, String name, String kind, String... endings) {
    FileChooser chooser = chooser(title);
    chooser.getExtensionFilters().addAll(new ExtensionFilter(kind, endings));
    chooser.setInitialFileName(suggested(name));
    return withFolder(chooser.showSaveDialog(owner))
        .map(file -> withOneEnding(file, name, endings));
  }

  /**
   * A chosen file without the suggested ending behind a typed one: GTK selects the suggested name
   * without its ending. An existing file is not chosen so, as nobody was asked.
   */
  static Path withOneEnding(Path chosen, String suggested, String... endings) {
    String ending = suggested.substring(suggested.lastIndexOf('.'));
    String typed = chosen.toString().replaceFirst(Pattern.quote(ending) + "$", "");
    boolean hasEnding = Stream.of(endings).anyMatch(each -> typed.endsWith(each.substring(1)));
    return hasEnding && !Files.exists(Path.of(typed)) ? Path.of(typed) : chosen;
  }

  /** A name that begins with that of what is open. */
  String suggested(String name) {
    return source + name;
  }

  private FileChooser chooser(String title) {
    FileChooser chooser = new FileChooser();
    chooser.setTitle(title);
    if (folder != null && folder.isDirectory()) {
      chooser.setInitialDirectory(folder);
    }
    return chooser;
  }

  private Optional<Path> withFolder(File chosen) {
    if (chosen == null) {
      return Optional.empty();
    }
    folder = chosen.getAbsoluteFile().getParentFile();
    return Optional.of(chosen.toPath());
  }
}
