package haltere.ui.viewer;

import haltere.ui.viewer.action.ViewerAction;
import haltere.ui.viewer.chain.EditHistory;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;

/** Takes changes of the chain and of settings back, and makes them once more. */
final class EditFeature implements ViewerFeature {
  @Override
  public void install(ViewerContext window) {
    EditHistory history = window.editor().history();
    window.add(
        ViewerAction.of("undo", "Undo", "Edit", () -> say(window, "Undone: ", history.undo()))
            .withKey("Shortcut+Z")
            .unless(() -> history.canUndo() ? "" : "nothing was changed")
            .withHelp("Takes back the last change of the chain or of a setting."),
        ViewerAction.of("redo", "Redo", "Edit", () -> say(window, "Redone: ", history.redo()))
            .withKey("Shortcut+Shift+Z")
            .unless(() -> history.canRedo() ? "" : "nothing was undone"));
  }

  private static void say(ViewerContext window, String what, String words) {
    window.status().setActivity(words.isEmpty() ? "Nothing to change." : what + words);
  }
}
