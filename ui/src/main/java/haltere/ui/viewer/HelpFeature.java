package haltere.ui.viewer;

import haltere.core.sink.internal.Unchecked;
import haltere.ui.viewer.action.CommandPalette;
import haltere.ui.viewer.action.KeysDialog;
import haltere.ui.viewer.action.ViewerActions;
import haltere.ui.viewer.controls.Controls;
import haltere.ui.viewer.controls.Windows;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;
import javafx.scene.control.Label;
import javafx.stage.Stage;

/** The command palette and the list of keys. */
final class HelpFeature implements ViewerFeature {
  @Override
  public void install(ViewerContext window) {
    CommandPalette palette = new CommandPalette(window.stage(), window.actions());
    Stage stage = window.stage();
    ViewerActions actions = window.actions();
    actions.add("palette", palette::show);
    actions.add("keys", () -> KeysDialog.show(stage, actions));
    actions.add("manual", () -> Manual.show(stage));
    actions.add("about", () -> about(stage));
  }

  private static void about(Stage owner) {
    String version = HelpFeature.class.getPackage().getImplementationVersion();
    String facts =
        Unchecked.text(HelpFeature.class.getResourceAsStream("about.txt"))
            .formatted(
                version == null ? "(not from a jar)" : version,
                System.getProperty("java.runtime.version"),
                System.getProperty("java.vendor"),
                System.getProperty("javafx.runtime.version", ""),
                System.getProperty("os.name"),
                System.getProperty("os.arch"));
    Windows.showContent(owner, "About Haltere", Controls.named(new Label(facts.strip()), "about"));
  }
}
