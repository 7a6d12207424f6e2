package haltere.ui;

import haltere.core.format.ReadOptions;
import haltere.ui.command.HaltereProgram;
import haltere.ui.command.WindowOpener;
import haltere.ui.viewer.ViewerApplication;
import java.nio.file.Path;
import java.util.Optional;

/**
 * Opens the viewer on the built-in scene and closes it after the first events, so that a JVM with
 * {@code -XX:DumpLoadedClassList} records the loaded classes. A class-data archive of them saves a
 * quarter of the start time. Run by the build only.
 */
final class ClassListRun implements WindowOpener {
  private ClassListRun() {}

  /** Runs the program with its arguments. */
  public static void main(String[] args) {
    System.exit(HaltereProgram.main(args, new ClassListRun()));
  }

  @Override
  public Optional<String> obstacle() {
    return Optional.empty();
  }

  @Override
  public boolean hasDisplay() {
    return true;
  }

  @Override
  public Optional<String> open(Optional<Path> file, ReadOptions options) {
    return ViewerApplication.rehearse();
  }
}
