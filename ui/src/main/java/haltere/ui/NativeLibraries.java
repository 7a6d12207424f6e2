package haltere.ui;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Stream;

/**
 * The system libraries that JavaFX loads on Linux. They are looked for before JavaFX starts,
 * because JavaFX itself answers a missing one with several pages of stack traces.
 */
final class NativeLibraries {
  /** Debian's names of all packages that the libraries are in. */
  static final String PACKAGES = "libgtk-3-0 libgl1 libxtst6";

  private record Library(String file, String debianPackage) {}

  private static final List<Library> NEEDED =
      List.of(
          new Library("libgtk-3.so.0", "libgtk-3-0"),
          new Library("libGL.so.1", "libgl1"),
          new Library("libXtst.so.6", "libxtst6"));

  private NativeLibraries() {}

  /**
   * One line for a user whose machine lacks libraries, empty if none is missing; they are looked
   * for by file name.
   */
  static Optional<String> complaint(Predicate<String> present) {
    List<String> files = new ArrayList<>();
    List<String> packages = new ArrayList<>();
    for (Library library : NEEDED) {
      if (!present.test(library.file())) {
        files.add(library.file());
        packages.add(library.debianPackage());
      }
    }
    if (files.isEmpty()) {
      return Optional.empty();
    }
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
    for (Path folder : folders()) {
      if (Files.exists(folder.resolve(file))) {
        return true;
      }
    }
    return linkerKnows(file);
  }

  private static List<Path> folders() {
    List<Path> folders = new ArrayList<>();
    for (String folder :
        Optional.ofNullable(System.getenv("LD_LIBRARY_PATH")).orElse("").split(":")) {
      if (!folder.isEmpty()) {
        folders.add(Path.of(folder));
      }
    }
    for (String root : List.of("/lib", "/usr/lib", "/lib64", "/usr/lib64", "/usr/local/lib")) {
      folders.add(Path.of(root));
      try (Stream<Path> inside = Files.list(Path.of(root))) {
        inside.filter(path -> path.toString().endsWith("-linux-gnu")).forEach(folders::add);
      } catch (IOException notThere) {
        continue;
      }
    }
    return folders;
  }

  /** Asks the linker's cache; where that is impossible, JavaFX may try. */
  private static boolean linkerKnows(String file) {
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
