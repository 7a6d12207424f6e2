package haltere.ui.command;

import haltere.core.format.ReadOptions;
import java.io.IOException;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** The program without a command: the viewer, or the same scene without a window. */
@Command(
    name = "haltere",
    footer = {"", "Example: haltere info recording.aedat4"},
    description = {
      "View, filter and track the events of event cameras.",
      "Without a command, opens the viewer on the built-in fly scene. Without a "
          + "display, runs the same chain and writes a picture and a table to build/demo/."
    },
    versionProvider = Version.class)
final class HaltereCommand extends Subcommand {
  @Option(names = "--headless", description = "Open no window, even with a display.")
  boolean headless;

  @Option(
      names = {"-V", "--version"},
      versionHelp = true,
      description = "Print the version.")
  boolean version;

  @Override
  public Integer call() throws IOException {
    WindowOpener window = surroundings().window();
    if (headless || !window.hasDisplay()) {
      return new HeadlessDemo(this).run();
    }
    openWindow(opener -> opener.open(Optional.empty(), ReadOptions.DEFAULT));
    return OK;
  }
}
