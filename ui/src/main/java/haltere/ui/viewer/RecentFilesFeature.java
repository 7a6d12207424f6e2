package haltere.ui.viewer;

import haltere.ui.viewer.action.ViewerAction;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Offers the recordings that were open last. */
final class RecentFilesFeature implements ViewerFeature {
  private static final String NAME = "recentFiles";
  private static final String MENU = "File/Open recent";
  private static final int MAX_FILES = 10;

  private final List<Path> files = new ArrayList<>();
  private ViewerContext window;

  @Override
  public void install(ViewerContext installed) {
    window = installed;
    if (window.settings().get(NAME).orElse(null) instanceof List<?> kept) {
      kept.forEach(file -> files.add(Path.of(file.toString())));
    }
    window.onSession(made -> made.request().file().ifPresent(this::opened));
    window.actions().add("open-last", this::openLast);
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
      window.sessions().open(files.get(0));
    }
  }

  private void opened(Path file) {
    Path whole = file.toAbsolutePath().normalize();
    if (!files.isEmpty() && files.get(0).equals(whole)) {
      return;
    }
    files.remove(whole);
    files.add(0, whole);
    if (files.size() > MAX_FILES) {
      files.remove(MAX_FILES);
    }
    window.settings().put(NAME, files.stream().map(Path::toString).toList());
    offer();
  }

  private void offer() {
    List<ViewerAction> offered = new ArrayList<>();
    for (Path file : files) {
      String id = "recent-" + (offered.size() + 1);
      Runnable open = () -> window.sessions().open(file);
      offered.add(
          ViewerAction.of(id, file.getFileName().toString(), MENU, open).withHelp(file.toString()));
    }
    window.actions().offer(NAME, offered);
  }
}
