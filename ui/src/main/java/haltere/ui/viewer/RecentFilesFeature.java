package haltere.ui.viewer;

import haltere.core.format.ReadOptions;
import haltere.ui.viewer.action.ViewerAction;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Offers the recordings that were open last.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class RecentFilesFeature implements ViewerFeature {
  private static final String NAME = "recentFiles";
  private static final String MENU = "File/Open recent";
  private static final int MOST = 10;

  private final List<Path> files = new ArrayList<>();
  private ViewerContext window;

  @Override
  public void install(ViewerContext installed) {
    window = installed;
    window
        .settings()
        .get(NAME)
        .filter(List.class::isInstance)
        .map(kept -> (List<?>) kept)
        .ifPresent(kept -> kept.forEach(file -> files.add(Path.of(file.toString()))));
    window.onSession(made -> made.file().ifPresent(this::opened));
    window.add(
        ViewerAction.of("open-last", "Open the last recording again", "File", this::openLast)
            .withKey("Shortcut+Shift+O"));
    offer();
  }

  /** The files, the one that was open last first. */
  List<Path> files() {
    return List.copyOf(files);
  }

  private void openLast() {
    if (files.isEmpty()) {
      window.status().setActivity("No recording has been opened yet.");
    } else {
      window.sessions().open(files.get(0), ReadOptions.DEFAULT);
    }
  }

  private void opened(Path file) {
    Path whole = file.toAbsolutePath().normalize();
    if (!files.isEmpty() && files.get(0).equals(whole)) {
      return;
    }
    files.remove(whole);
    files.add(0, whole);
    if (files.size() > MOST) {
      files.remove(MOST);
    }
    window.settings().put(NAME, files.stream().map(Path::toString).toList());
    offer();
  }

  private void offer() {
    List<String> old = new ArrayList<>();
    for (int i = 0; i < MOST; i++) {
      old.add(id(i));
    }
    ViewerAction[] offered = new ViewerAction[files.size()];
    for (int i = 0; i < offered.length; i++) {
      Path file = files.get(i);
      offered[i] =
          ViewerAction.of(
                  id(i),
                  file.getFileName().toString(),
                  MENU,
                  () -> window.sessions().open(file, ReadOptions.DEFAULT))
              .withHelp(file.toString());
    }
    window.actions().replace(old, offered);
  }

  private static String id(int place) {
    return "recent-" + (place + 1);
  }
}
