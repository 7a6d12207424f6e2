package haltere.ui.viewer;

import haltere.ui.viewer.action.CommandPalette;
import haltere.ui.viewer.action.KeysDialog;
import haltere.ui.viewer.action.ViewerAction;
import haltere.ui.viewer.controls.Windows;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;
import javafx.scene.control.Label;
import javafx.stage.Stage;

/** The command palette and the list of keys. */
final class HelpFeature implements ViewerFeature {
  private static final String LIBRARIES =
      """
      OpenJFX: GPL-2.0 with Classpath Exception
      AtlantaFX: MIT
      picocli, EJML, Jackson, Commons Statistics: Apache-2.0
      usb4java: MIT; libusb: LGPL-2.1
      JeroMQ: MPL-2.0
      zstd-jni: BSD-2-Clause""";

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
                .withKey("F1"),
            ViewerAction.of("manual", "Manual", "Help", () -> Manual.show(window.stage()))
                .withHelp("What the viewer can do, to be read beside it."),
            ViewerAction.of("about", "About Haltere", "Help", () -> about(window.stage()))
                .withHelp("Version, Java and licences."));
  }

  private static void about(Stage owner) {
    String version = HelpFeature.class.getPackage().getImplementationVersion();
    Label facts =
        new Label(
            "Haltere "
                + (version == null ? "(not from a jar)" : version)
                + "\nLicence: Apache-2.0\n\nJava "
                + System.getProperty("java.runtime.version")
                + " of "
                + System.getProperty("java.vendor")
                + "\nJavaFX "
                + System.getProperty("javafx.runtime.version", "")
                + "\n"
                + System.getProperty("os.name")
                + " "
                + System.getProperty("os.arch")
                + "\n\nLibraries and their licences:\n"
                + LIBRARIES);
    facts.setId("about");
    Windows.tell(owner, "About Haltere", facts);
  }
}
