package haltere.ui.viewer;

import haltere.ui.viewer.action.ViewerAction;
import haltere.ui.viewer.feature.PanelPlace;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;
import haltere.ui.viewer.plots.PlotPanel;
import haltere.ui.viewer.saving.Saving;
import javafx.beans.property.BooleanProperty;

/** Plots of what filters publish, below the events. */
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
    window
        .actions()
        .add(
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
}
