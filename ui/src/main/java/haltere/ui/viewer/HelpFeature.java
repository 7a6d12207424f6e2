package haltere.ui.viewer;

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
  private static final String FACTS =
      """
      Haltere %s
      Licence: Apache-2.0

      Java %s of %s
      JavaFX %s
      %s %s

      Libraries and their licences:
      OpenJFX: GPL-2.0 with Classpath Exception
      AtlantaFX: MIT
      picocli, EJML, Jackson, lz4-java, Commons Compress, Commons Statistics: Apache-2.0
      usb4java: MIT; libusb: LGPL-2.1
      zstd-jni, LZ4: BSD-2-Clause""";

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
        FACTS.formatted(
            version == null ? "(not from a jar)" : version,
            System.getProperty("java.runtime.version"),
            System.getProperty("java.vendor"),
            System.getProperty("javafx.runtime.version", ""),
            System.getProperty("os.name"),
            System.getProperty("os.arch"));
    Windows.showContent(owner, "About Haltere", Controls.named(new Label(facts), "about"));
  }
}
