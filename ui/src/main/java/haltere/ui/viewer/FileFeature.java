package haltere.ui.viewer;

import haltere.core.simulation.SceneProvider;
import haltere.core.simulation.Scenes;
import haltere.ui.viewer.action.ViewerAction;
import haltere.ui.viewer.action.ViewerActions;
import haltere.ui.viewer.controls.Texts;
import haltere.ui.viewer.feature.Sessions;
import haltere.ui.viewer.feature.WindowFeature;
import haltere.ui.viewer.session.SessionRequest;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** Opens recordings, recent ones, and the built-in scenes. */
final class FileFeature extends WindowFeature {
  private static final String NAME = "recentFiles";
  private static final String RECENT = "File/Open recent";
  private static final String SCENES = "File/Open scene";
  private static final int MAX_FILES = 10;

  /** The most recently opened file is the first. */
  private final List<Path> files = new ArrayList<>();

  @Override
  protected void install() {
    if (window.settings().get(NAME).orElse(null) instanceof List<?> kept) {
      kept.forEach(file -> files.add(Path.of(file.toString())));
    }
    ViewerActions actions = window.actions();
    actions.add("open", () -> window.dialogs().recording().ifPresent(window.sessions()::open));
    addScenes(actions, window.sessions());
    window.onSession(made -> made.request().file().ifPresent(this::opened));
    actions.add(
        "open-last",
        () -> window.sessions().open(files.get(0)),
        () -> files.isEmpty() ? "no recording has been opened" : "");
    offer();
  }

  private static void addScenes(ViewerActions actions, Sessions sessions) {
    actions.add("open-scene", () -> sessions.open(SessionRequest.scene()));
    List<SceneProvider<?>> scenes = new ArrayList<>(Scenes.all().values());
    // the default is the first
    scenes.sort(Comparator.comparing(scene -> !scene.name().equals("fly")));
    for (SceneProvider<?> scene : scenes) {
      String title = Texts.title(scene.name()) + " scene";
      actions.add(
          ViewerAction.of(
                  "scene-" + scene.name(),
                  title,
                  SCENES,
                  () -> sessions.open(SessionRequest.scene(scene.name(), title)))
              .withHelp(scene.description()));
    }
  }

  private void opened(Path file) {
    Path whole = file.toAbsolutePath().normalize();
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
          ViewerAction.of(id, file.getFileName().toString(), RECENT, open)
              .withHelp(file.toString()));
    }
    window.actions().offer(NAME, offered);
  }
}
