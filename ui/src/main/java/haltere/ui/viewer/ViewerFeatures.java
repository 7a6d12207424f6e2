package haltere.ui.viewer;

import haltere.ui.viewer.cameras.CameraFeature;
import haltere.ui.viewer.compare.CompareFeature;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;
import haltere.ui.viewer.file.FileInfoFeature;
import haltere.ui.viewer.file.SamplesFeature;
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

/** All features of the window; their order is that of the menus. */
final class ViewerFeatures {
  private ViewerFeatures() {}

  static List<ViewerFeature> all() {
    return List.of(
        new SettingsFeature(),
        new FileFeature(),
        new UsualFiltersFeature(),
        new FileInfoFeature(),
        new SamplesFeature(),
        new RecentFilesFeature(),
        new SavingFeature(),
        new ExportFeature(),
        new EditFeature(),
        new BodyFlightFeature(),
        new LiveFlightFeature(),
        new DisplayFeature(),
        new SeeingFeature(),
        new VanishingPointFeature(),
        new SpaceTimeFeature(),
        new PlotFeature(),
        new PanelFeature(),
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
        ViewerFeatures::quit);
  }

  private static void quit(ViewerContext window) {
    window.actions().add("quit", window.stage()::close);
  }
}
