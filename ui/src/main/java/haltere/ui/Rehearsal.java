package haltere.ui;

import haltere.core.format.ReadOptions;
import haltere.ui.command.HaltereProgram;
import haltere.ui.command.WindowOpener;
import haltere.ui.viewer.ViewerApplication;
import java.nio.file.Path;
import java.util.Optional;

/**
 * Opens the viewer on the built-in scene and closes it once events are shown, so that a JVM that
 * was started with {@code -XX:DumpLoadedClassList} notes the classes that this takes. Mapped from
 * an archive they are there in a moment; loading them one by one is a quarter of the time until the
 * window shows events. The build runs this, no user does.
 */
final class Rehearsal implements WindowOpener {
  private Rehearsal() {}

  /** Runs the program with its words. */
  public static void main(String[] args) {
    System.exit(HaltereProgram.main(args, new Rehearsal()));
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
