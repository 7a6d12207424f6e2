package haltere.ui;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Stream;

/**
 * System libraries that JavaFX loads on Linux, checked before JavaFX starts: for a missing one,
 * JavaFX prints pages of stack traces.
 */
final class NativeLibraries {
  /** Debian's names of the packages that the libraries are in, in the same order. */
  static final String PACKAGES = "libgtk-3-0 libgl1 libxtst6";

  private static final List<String> NEEDED = List.of("libgtk-3.so.0", "libGL.so.1", "libXtst.so.6");

  /** Default folders of the linker. */
  private static final List<String> DEFAULT_FOLDERS =
      List.of(
          "/usr/lib/x86_64-linux-gnu",
          "/usr/lib/aarch64-linux-gnu",
          "/usr/lib64",
          "/usr/lib",
          "/lib64",
          "/lib",
          "/usr/local/lib");

  private NativeLibraries() {}

  /**
   * One line for a user whose machine lacks libraries, empty if none is missing; they are looked
   * for by file name.
   */
  static Optional<String> complaint(Predicate<String> present) {
    List<String> files = NEEDED.stream().filter(present.negate()).toList();
    if (files.isEmpty()) {
      return Optional.empty();
    }
    List<String> all = List.of(PACKAGES.split(" "));
    List<String> packages = files.stream().map(file -> all.get(NEEDED.indexOf(file))).toList();
    return Optional.of(
        "the window needs graphics libraries that are not here ("
            + String.join(", ", files)
            + "): install the packages "
            + String.join(" ", packages)
            + " (these are Debian's names; all of them: "
            + PACKAGES
            + "), or go without a window: haltere --headless");
  }

  /**
   * Whether this machine has a library of this file name; false only if it was looked for
   * everywhere.
   */
  static boolean present(String file) {
    String searchPath = Optional.ofNullable(System.getenv("LD_LIBRARY_PATH")).orElse("");
    return Stream.concat(Stream.of(searchPath.split(":")), DEFAULT_FOLDERS.stream())
            .filter(folder -> !folder.isEmpty())
            .anyMatch(folder -> Files.exists(Path.of(folder, file)))
        || isOnLinkerPath(file);
  }

  /** Searches the linker's cache; true if that is impossible, so that JavaFX tries. */
  private static boolean isOnLinkerPath(String file) {
    for (String command : List.of("/sbin/ldconfig", "/usr/sbin/ldconfig")) {
      if (Files.isExecutable(Path.of(command))) {
        try {
          Process process = new ProcessBuilder(command, "-p").redirectErrorStream(true).start();
          process.getOutputStream().close();
          try (InputStream answer = process.getInputStream()) {
            return isListed(file, new String(answer.readAllBytes(), StandardCharsets.UTF_8));
          }
        } catch (IOException noAnswer) {
          return true;
        }
      }
    }
    return true;
  }

  /** Whether a list of lines {@code name (kind) => path} has the file, and it still exists. */
  static boolean isListed(String file, String list) {
    return list.lines()
        .map(String::strip)
        .filter(line -> line.startsWith(file + " "))
        .map(line -> line.substring(line.lastIndexOf("=> ") + 3))
        .anyMatch(path -> Files.exists(Path.of(path)));
  }
}
