package haltere.ui.command;

import haltere.core.camera.Cameras;
import haltere.core.chain.Filters;
import haltere.core.extension.Extensions;
import haltere.core.format.Recordings;
import haltere.core.simulation.Scenes;
import haltere.core.sink.LineOutputs;
import haltere.ui.user.ConfigFolder;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/** The folder of jars with additional filters, formats and scenes. */
final class ExtensionFolder {
  static final String OPTION = "--extensions";
  private static final String VARIABLE = "HALTERE_EXTENSIONS";
  private static final String DEFAULT_NAME = "extensions";

  private ExtensionFolder() {}

  /**
   * Opens the folder of the option, of the environment, or beside the settings, and returns skipped
   * jars, one line each. Runs before the command line is parsed, as a format may be one of its
   * values.
   */
  static List<String> open(String[] args, Map<String, String> environment) throws IOException {
    String named = environment.getOrDefault(VARIABLE, "");
    for (int i = 0; i < args.length; i++) {
      if (args[i].startsWith(OPTION + "=")) {
        named = args[i].substring(OPTION.length() + 1);
      } else if (args[i].equals(OPTION) && i + 1 < args.length) {
        named = args[i + 1];
      }
    }
    if (!named.isEmpty() && !Files.isDirectory(Path.of(named))) {
      throw new CommandProblem(named + ": there is no such folder of extensions");
    }
    Path folder = named.isEmpty() ? ConfigFolder.ofUser().resolve(DEFAULT_NAME) : Path.of(named);
    if (Extensions.open(folder).isEmpty()) {
      return List.of();
    }
    Filters.all();
    Recordings.formats();
    Scenes.all();
    LineOutputs.all();
    Cameras.installed();
    return Extensions.problems();
  }
}
