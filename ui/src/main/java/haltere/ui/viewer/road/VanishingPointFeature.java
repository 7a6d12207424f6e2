package haltere.ui.viewer.road;

import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterChain;
import haltere.core.settings.SettingsProblem;
import haltere.filters.plane.VanishingPoint;
import haltere.filters.track.KalmanTracksFilter;
import haltere.filters.track.KalmanTracksSettings;
import haltere.ui.viewer.feature.WindowFeature;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import javafx.beans.property.BooleanProperty;
import javafx.geometry.Point2D;

/** Sets the vanishing point of a road by a click, for the first Kalman tracks in the chain. */
public final class VanishingPointFeature extends WindowFeature {
  private BooleanProperty marking;
  private final PointsTool tool =
      new PointsTool(
          this::mark,
          "Click the vanishing point of the road; tracks are then in metres on the road.");
  private boolean hasTracks;

  /** The tracks of a chain and their settings, read off on the processing thread. */
  private record Tracks(ChainStage stage, KalmanTracksSettings settings) {
    static Optional<Tracks> of(FilterChain chain) {
      return chain.stages().stream()
          .filter(stage -> stage.filter() instanceof KalmanTracksFilter)
          .map(stage -> new Tracks(stage, ((KalmanTracksFilter) stage.filter()).settings()))
          .findFirst();
    }

    List<Point2D> mark() {
      VanishingPoint point = settings.road().view().vanishingPoint();
      return point.marked() ? List.of(new Point2D(point.xPx(), point.yPx())) : List.of();
    }

    KalmanTracksSettings vanishingAt(Point2D at) {
      return settings.with(
          "road.mapToRoad=true",
          "road.view.vanishingPoint.marked=true",
          "road.view.vanishingPoint.xPx=" + at.getX(),
          "road.view.vanishingPoint.yPx=" + at.getY());
    }
  }

  @Override
  protected void install() {
    Supplier<String> obstacle = () -> hasTracks ? "" : "no filter of Kalman tracks in the chain";
    marking = window.addTool("vanishing-point", tool, obstacle);
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
    tool.show(tracks.map(Tracks::mark).orElse(List.of()));
    window.panels().view().redraw();
  }

  private void mark(List<Point2D> points) {
    window.read(Tracks::of, tracks -> tracks.ifPresent(found -> mark(found, points.get(0))));
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
}
