package haltere.ui.viewer;

import haltere.core.simulation.SceneProvider;
import haltere.core.simulation.Scenes;
import haltere.ui.viewer.action.ViewerAction;
import haltere.ui.viewer.action.ViewerActions;
import haltere.ui.viewer.controls.Texts;
import haltere.ui.viewer.feature.Sessions;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;
import haltere.ui.viewer.session.SessionRequest;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** Opens recordings and the built-in scene. */
final class FileFeature implements ViewerFeature {
  private static final String SCENES = "File/Open scene";

  @Override
  public void install(ViewerContext window) {
    ViewerActions actions = window.actions();
    Sessions sessions = window.sessions();
    actions.add("open", () -> window.dialogs().recording().ifPresent(sessions::open));
    actions.add("open-scene", () -> sessions.open(SessionRequest.scene()));
    List<SceneProvider<?>> scenes = new ArrayList<>(Scenes.all().values());
    // the one to begin with stands first
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
}
