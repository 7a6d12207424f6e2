package haltere.ui.command;

import java.nio.file.Path;
import picocli.CommandLine.Option;

/** Options that every command has. */
final class MessageOptions {
  @Option(
      names = ExtensionFolder.OPTION,
      order = 999,
      paramLabel = "FOLDER",
      description =
          "Where jars with more filters, formats and scenes are; if not given: $HALTERE_EXTENSIONS,"
              + " or the folder extensions beside the settings.")
  Path extensions;

  @Option(
      names = "--quiet",
      order = 1000,
      description = "No progress bar and no messages; warnings and errors remain.")
  boolean quiet;

  @Option(names = "--debug", order = 1001, description = "Print the stack trace of an error.")
  boolean debug;

  @Option(
      names = {"-h", "--help"},
      order = 1002,
      usageHelp = true,
      description = "Print this help.")
  boolean help;
}
