package haltere.ui.viewer;

import haltere.ui.viewer.action.ViewerActions;
import haltere.ui.viewer.chain.EditHistory;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;

/** Takes changes of the chain and of settings back, and makes them once more. */
final class EditFeature implements ViewerFeature {
  @Override
  public void install(ViewerContext window) {
    ViewerActions actions = window.actions();
    EditHistory history = window.editor().history();
    actions.add(
        "undo",
        () -> say(window, "Undone: ", history.undo()),
        () -> history.canUndo() ? "" : "nothing was changed");
    actions.add(
        "redo",
        () -> say(window, "Redone: ", history.redo()),
        () -> history.canRedo() ? "" : "nothing was undone");
  }

  private static void say(ViewerContext window, String what, String words) {
    window.status().setActivity(words.isEmpty() ? "Nothing to change." : what + words);
  }
}
