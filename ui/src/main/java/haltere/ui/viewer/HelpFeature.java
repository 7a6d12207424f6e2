package haltere.ui.viewer;

import haltere.ui.viewer.action.CommandPalette;
import haltere.ui.viewer.action.KeysDialog;
import haltere.ui.viewer.action.ViewerAction;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;

/** The command palette and the list of keys. */
final class HelpFeature implements ViewerFeature {
  @Override
  public void install(ViewerContext window) {
    CommandPalette palette = new CommandPalette(window.stage(), window.actions());
    window
        .actions()
        .add(
            ViewerAction.of("palette", "Find a command\u2026", "Help", palette::show)
                .withKey("Shortcut+K")
                .withHelp("Searches all commands by their words and does the one chosen."),
            ViewerAction.of(
                    "keys", "Keys", "Help", () -> KeysDialog.show(window.stage(), window.actions()))
                .withKey("F1"));
  }
}
