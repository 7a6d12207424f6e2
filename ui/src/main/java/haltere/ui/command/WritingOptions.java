package haltere.ui.command;

import haltere.core.sink.Tables;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import picocli.CommandLine.Option;

/** Options of every command that writes files, and the checks that come before the work. */
class WritingOptions {
  @Option(names = "--overwrite", description = "Replace output files that exist.")
  boolean overwrite;

  /**
   * Refuses an output that cannot be written, before any work is done.
   *
   * @param output where a file will be
   * @throws CommandProblem if it exists, is a folder, has no folder to be in, or is a table of a
   *     format that is not installed
   */
  void check(Path output) {
    Path folder = output.toAbsolutePath().getParent();
    if (Files.isDirectory(output)) {
      throw new CommandProblem(output + ": this is a folder; name a file in it");
    }
    if (folder == null || !Files.isDirectory(folder)) {
      throw new CommandProblem(
          output + ": there is no folder " + folder + "; make it, or choose another place");
    }
    Tables.problem(output)
        .ifPresent(
            missing -> {
              throw new CommandProblem(output + ": " + missing);
            });
    if (Files.exists(output, LinkOption.NOFOLLOW_LINKS) && !overwrite) {
      throw new CommandProblem(output + ": exists already; give --overwrite to replace it");
    }
    if (!Files.isWritable(folder)) {
      throw new CommandProblem(
          output + ": no permission to write in its folder; choose another place");
    }
  }

  /**
   * Refuses an output that would replace what is being read.
   *
   * @param input a file that is read
   * @param output where a file will be
   * @throws CommandProblem if they are the same
   * @throws IOException if the file system cannot tell
   */
  static void checkDifferent(Path input, Path output) throws IOException {
    boolean same =
        Files.exists(input) && Files.exists(output)
            ? Files.isSameFile(input, output)
            : input.toAbsolutePath().normalize().equals(output.toAbsolutePath().normalize());
    if (same) {
      throw new CommandProblem(
          output + ": input and output are the same file; choose another output");
    }
  }
}
