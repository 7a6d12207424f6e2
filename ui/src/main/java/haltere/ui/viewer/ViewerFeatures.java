package haltere.ui.viewer;

import haltere.ui.viewer.action.ViewerActions;
import haltere.ui.viewer.cameras.CameraFeature;
import haltere.ui.viewer.chain.EditHistory;
import haltere.ui.viewer.compare.CompareFeature;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;
import haltere.ui.viewer.file.FileInfoFeature;
import haltere.ui.viewer.file.SamplesFeature;
import haltere.ui.viewer.road.PlaneFeature;
import haltere.ui.viewer.road.VanishingPointFeature;
import haltere.ui.viewer.saving.ExportFeature;
import haltere.ui.viewer.saving.PublishFeature;
import haltere.ui.viewer.saving.SavingFeature;
import haltere.ui.viewer.space.BodyFlightFeature;
import haltere.ui.viewer.space.LiveFlightFeature;
import haltere.ui.viewer.space.SpaceTimeFeature;
import haltere.ui.viewer.start.StartFeature;
import haltere.ui.viewer.wings.WingsFeature;
import java.util.List;

/** All features of the window, in the order of the menus. */
final class ViewerFeatures {
  private ViewerFeatures() {}

  static List<ViewerFeature> all() {
    return List.of(
        new SettingsFeature(),
        new FileFeature(),
        new CommonFiltersFeature(),
        new FileInfoFeature(),
        new SamplesFeature(),
        new SavingFeature(),
        new ExportFeature(),
        ViewerFeatures::undoAndRedo,
        new BodyFlightFeature(),
        new LiveFlightFeature(),
        new DisplayFeature(),
        new InspectionFeature(),
        new VanishingPointFeature(),
        new PlaneFeature(),
        new SpaceTimeFeature(),
        new PlotFeature(),
        new LayoutFeature(),
        new WingsFeature(),
        new FlyStartFeature(),
        new PlaybackFeature(),
        new CameraFeature(),
        new PublishFeature(),
        new BeatExposure(),
        new CompareFeature(),
        new PresetFeature(),
        new StartFeature(),
        new HelpFeature(),
        window -> window.actions().add("quit", window.stage()::close));
  }

  /** Undo and redo of changes of the chain and of settings. */
  private static void undoAndRedo(ViewerContext window) {
    ViewerActions actions = window.actions();
    EditHistory history = window.editor().history();
    actions.add(
        "undo",
        () -> window.status().setActivity("Undone: " + history.undo()),
        () -> history.canUndo() ? "" : "nothing was changed");
    actions.add(
        "redo",
        () -> window.status().setActivity("Redone: " + history.redo()),
        () -> history.canRedo() ? "" : "nothing was undone");
  }
}
