package haltere.ui.command;

import haltere.core.format.AtomicFile;
import haltere.core.format.internal.SameFile;
import haltere.core.sink.Tables;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Set;
import picocli.CommandLine.Option;

/** Options of commands that write files, and their checks before the work. */
class WritingOptions extends OptionGroup {
  @Option(names = "--overwrite", description = "Replace existing output files.")
  boolean overwrite;

  /**
   * Refuses, by a {@link CommandProblem} before any work, an output that exists, is a folder, has
   * no folder to be in, or is a table of a format that is not installed.
   */
  void check(Path output) {
    if (ReadingOptions.isStandard(output)) {
      throw wrong("-: standard output is only for haltere convert; name a file");
    }
    Path folder = output.toAbsolutePath().getParent();
    if (Files.isDirectory(output)) {
      throw new CommandProblem(output + ": this is a folder already; choose another name");
    }
    if (folder == null || !Files.isDirectory(folder)) {
      throw new CommandProblem(
          output + ": there is no folder " + folder + "; create it, or choose another place");
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
   * Refuses outputs before any work: those that cannot be written, that would replace an input, or
   * that have the same name. Files that are not given are null.
   */
  void check(List<Path> inputs, List<Path> outputs) throws IOException {
    Set<Path> seen = new HashSet<>();
    for (Path output : outputs.stream().filter(Objects::nonNull).toList()) {
      check(output);
      for (Path input : inputs.stream().filter(Objects::nonNull).toList()) {
        checkDifferent(input, output);
      }
      if (!seen.add(output.toAbsolutePath().normalize())) {
        throw wrong(output + " would be written by two outputs");
      }
    }
  }

  /** Whether a name has an ending, in letters of any case as for all formats. */
  static boolean hasEnding(Path file, String ending) {
    return file.toString().toLowerCase(Locale.ROOT).endsWith(ending);
  }

  /** Begins a table's file. */
  AtomicFile begin(Path file) throws IOException {
    return AtomicFile.create(file, overwrite);
  }

  /** Refuses, by a {@link CommandProblem}, an output that would replace an input. */
  static void checkDifferent(Path input, Path output) throws IOException {
    if (SameFile.is(input, output)) {
      throw new CommandProblem(
          output + ": input and output are the same file; choose another output");
    }
  }
}
