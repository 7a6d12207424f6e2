package haltere.ui.viewer.road;

import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterChain;
import haltere.core.settings.SettingsProblem;
import haltere.filters.plane.VanishingPoint;
import haltere.filters.track.KalmanTracksFilter;
import haltere.filters.track.KalmanTracksSettings;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;
import java.util.Optional;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.geometry.Point2D;

/** Sets the vanishing point of a road by a click, for the first Kalman tracks in the chain. */
public final class VanishingPointFeature implements ViewerFeature {
  private static final double STEPS_PER_PX = 10;

  private final BooleanProperty marking = new SimpleBooleanProperty();
  private final VanishingPointTool tool = new VanishingPointTool(this::mark);
  private ViewerContext window;
  private boolean hasTracks;

  /** The tracks of a chain and their settings, read off on the processing thread. */
  private record Tracks(ChainStage stage, KalmanTracksSettings settings) {
    static Optional<Tracks> of(FilterChain chain) {
      return chain.stages().stream()
          .filter(stage -> stage.filter() instanceof KalmanTracksFilter)
          .map(stage -> new Tracks(stage, ((KalmanTracksFilter) stage.filter()).settings()))
          .findFirst();
    }

    VanishingPoint point() {
      return settings.road().view().vanishingPoint();
    }

    KalmanTracksSettings vanishingAt(Point2D at) {
      return settings.with(
          "road.mapToRoad=true",
          "road.view.vanishingPoint.marked=true",
          "road.view.vanishingPoint.xPx=" + rounded(at.getX()),
          "road.view.vanishingPoint.yPx=" + rounded(at.getY()));
    }
  }

  @Override
  public void install(ViewerContext installed) {
    window = installed;
    window.bindTool(marking, tool);
    window
        .actions()
        .add(
            "vanishing-point",
            marking,
            () -> hasTracks ? "" : "no filter of Kalman tracks in the chain");
    window.editor().onChange(this::look);
    // Selecting the tool shows the present mark, however it was set.
    marking.subscribe((was, is) -> look());
    window.editor().onSettings((stage, settings) -> look());
  }

  private void look() {
    window.read(Tracks::of, this::offer);
  }

  private void offer(Optional<Tracks> tracks) {
    hasTracks = tracks.isPresent();
    marking.set(marking.get() && hasTracks);
    tool.show(
        tracks
            .map(Tracks::point)
            .filter(VanishingPoint::marked)
            .map(point -> new Point2D(point.xPx(), point.yPx())));
    window.panels().view().redraw();
  }

  private void mark(Point2D at) {
    window.read(Tracks::of, tracks -> tracks.ifPresent(found -> mark(found, at)));
  }

  private void mark(Tracks tracks, Point2D at) {
    try {
      window.status().showRefusal("");
      window
          .editor()
          .apply(
              tracks.stage(),
              tracks.settings(),
              tracks.vanishingAt(at),
              "Vanishing point",
              window.status()::showRefusal);
    } catch (SettingsProblem problem) {
      window.status().showRefusal(problem.getMessage());
      look();
    }
  }

  private static double rounded(double placePx) {
    return Math.rint(placePx * STEPS_PER_PX) / STEPS_PER_PX;
  }
}
