package haltere.ui.command;

import haltere.core.format.ReadOptions;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** Opens the viewer. */
@Command(name = "view", description = "Open the viewer on a recording, or on its start page.")
final class ViewCommand extends Subcommand {
  @Parameters(arity = "0..1", paramLabel = "FILE", description = "A recording.")
  Path file;

  @Mixin ReadingOptions reading;

  @Override
  public Integer call() throws IOException {
    reading.checkNeeded(file);
    boolean display = surroundings().window().hasDisplay();
    if (file != null && (surroundings().errIsTerminal() || !display)) {
      // without a terminal, the window reports a bad recording
      reading.open(file).close();
    }
    if (!display) {
      throw new CommandProblem(
          "there is no display for a window: set DISPLAY, or use haltere info and "
              + "haltere run, which need none");
    }
    ReadOptions options = reading.readOptions();
    openWindow(
        opener -> file == null ? opener.openStartPage() : opener.open(Optional.of(file), options));
    return OK;
  }
}
