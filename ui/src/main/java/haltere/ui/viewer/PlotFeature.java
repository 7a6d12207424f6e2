package haltere.ui.viewer;

import haltere.ui.viewer.action.ViewerAction;
import haltere.ui.viewer.action.ViewerKeys;
import haltere.ui.viewer.controls.Windows;
import haltere.ui.viewer.feature.PanelPlace;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;
import haltere.ui.viewer.plots.PlotPanel;
import haltere.ui.viewer.saving.Saving;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.scene.layout.StackPane;
import javafx.stage.Stage;

/**
 * Plots of what filters publish, below the events or in a window of their own.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class PlotFeature implements ViewerFeature {
  @Override
  public void install(ViewerContext window) {
    PlotPanel plots = window.panels().plots();
    Saving saving = new Saving(window.background(), window.editor(), window.status()::showError);
    BooleanProperty shown =
        window.addPanel("plots", "Plots", "Shortcut+G", PanelPlace.BELOW, () -> plots);
    window.onSession(
        made -> {
          if (plots.dropFirst(made.chain())) {
            shown.set(false);
          }
          if (plots.beginWith(made.start().plots())) {
            shown.set(true);
          }
        });
    BooleanProperty apart = new SimpleBooleanProperty();
    followPlace(window, plots, shown, apart);
    window
        .actions()
        .add(
            ViewerAction.toggle("plots-apart", "Plots in a window of their own", "View", apart)
                .withHelp("Takes the plots out of this window, such as to another screen."),
            ViewerAction.of(
                "save-plot-table",
                "Save plots as table\u2026",
                "File",
                () ->
                    window.dialogs().table().ifPresent(file -> saving.plots(file, plots.table()))),
            ViewerAction.of(
                "save-plot-picture",
                "Save plots as picture\u2026",
                "File",
                () ->
                    window
                        .dialogs()
                        .picture()
                        .ifPresent(file -> saving.plots(file, plots.snapshot(null, null)))));
  }

  /** Plots are at one place at a time: closing their window puts them below the events again. */
  private static void followPlace(
      ViewerContext window, PlotPanel plots, BooleanProperty shown, BooleanProperty apart) {
    Stage[] own = new Stage[1];
    apart.addListener(
        (property, was, is) -> {
          if (is) {
            shown.set(false);
            own[0] =
                Windows.beside(
                    window.stage(), "Plots \u2013 Haltere", new StackPane(plots), 900, 480);
            ViewerKeys.install(own[0].getScene(), window.actions());
            own[0].setOnHidden(event -> apart.set(false));
            own[0].show();
          } else {
            own[0].hide();
            shown.set(true);
          }
        });
    shown.addListener(
        (property, was, is) -> {
          if (is) {
            apart.set(false);
          }
        });
  }
}
