package haltere.ui.viewer;

import haltere.core.format.ReadOptions;
import haltere.ui.viewer.action.ViewerAction;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;
import haltere.ui.viewer.session.SessionRequest;

/** Opens recordings and the built-in scene. */
final class FileFeature implements ViewerFeature {
  @Override
  public void install(ViewerContext window) {
    window
        .actions()
        .add(
            ViewerAction.of(
                    "open",
                    "Open recording\u2026",
                    "File",
                    () ->
                        window
                            .dialogs()
                            .recording()
                            .ifPresent(file -> window.sessions().open(file, ReadOptions.DEFAULT)))
                .withKey("Shortcut+O")
                .withHelp("Opens a recording; dropping one on the window does the same."),
            ViewerAction.of(
                "open-scene",
                "Open the fly scene",
                "File",
                () -> window.sessions().open(SessionRequest.scene())));
  }
}
