package haltere.ui;

import haltere.core.format.ReadOptions;
import haltere.ui.command.WindowOpener;
import haltere.ui.viewer.ViewerApplication;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;

/** Tests whether JavaFX can open a window, and opens it. Loads no JavaFX class before that. */
final class JavaFxWindow implements WindowOpener {
  @Override
  public boolean hasDisplay() {
    return hasOwnScreen() || !isLinux() || !System.getenv().getOrDefault("DISPLAY", "").isEmpty();
  }

  @Override
  public Optional<String> obstacle() {
    if (getClass().getClassLoader().getResource("javafx/application/Application.class") == null
        && ModuleLayer.boot().findModule("javafx.controls").isEmpty()) {
      return Optional.of(
          "JavaFX is not on the module path; start the viewer with the installed script: haltere"
              + " view");
    }
    return isLinux() && !hasOwnScreen()
        ? NativeLibraries.complaint(NativeLibraries::present)
        : Optional.empty();
  }

  @Override
  public Optional<String> open(Optional<Path> file, ReadOptions options) {
    return explained(ViewerApplication.open(file, options));
  }

  @Override
  public Optional<String> openStartPage() {
    return explained(ViewerApplication.openStartPage());
  }

  private static Optional<String> explained(Optional<String> obstacle) {
    return obstacle.map(
        problem ->
            problem.contains("Unable to load")
                ? problem + " It comes with the packages " + NativeLibraries.PACKAGES
                : problem);
  }

  /** Whether JavaFX is configured to draw into memory, as in tests. */
  private static boolean hasOwnScreen() {
    String platform = System.getProperty("glass.platform", "");
    return platform.equals("Monocle") || platform.equals("Headless");
  }

  private static boolean isLinux() {
    return System.getProperty("os.name").toLowerCase(Locale.ROOT).contains("linux");
  }
}
