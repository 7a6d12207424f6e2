package haltere.ui.viewer;

import haltere.core.event.SensorGeometry;
import haltere.filters.frequency.PixelRegion;
import haltere.ui.viewer.action.ViewerActions;
import haltere.ui.viewer.controls.Icons;
import haltere.ui.viewer.feature.DisplayControl;
import haltere.ui.viewer.feature.ViewBar;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;
import haltere.ui.viewer.picture.EventView;
import haltere.ui.viewer.picture.MeasuringTape;
import haltere.ui.viewer.picture.PointTool;
import haltere.ui.viewer.picture.RegionLayer;
import haltere.ui.viewer.picture.RegionTool;
import java.util.Optional;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;

/**
 * Looking closely: the pixel under the mouse, a region of interest, the measuring tape, zoom.
 *
 * <p>Thread rule: JavaFX thread only.
 */
public final class SeeingFeature implements ViewerFeature {
  private static final double ZOOM_STEP = 1.5;
  private static final double PAN_STEP = 0.1;

  private final RegionLayer layer = new RegionLayer();
  private final BooleanProperty measuring = new SimpleBooleanProperty();
  private final BooleanProperty drawingRegion = new SimpleBooleanProperty();
  private final BooleanProperty pointing = new SimpleBooleanProperty();
  private ViewerContext window;
  private MeasuringTape tape;

  @Override
  public void install(ViewerContext installed) {
    window = installed;
    tape = new MeasuringTape(window.display().tapeProperty());
    EventView view = window.panels().view();
    view.setPointerListener(
        (x, y, over) -> window.ifOpen(open -> open.display().point(x, y, over)));
    view.addLayer(layer::draw);
    view.onFrame(frame -> frame.region().ifPresent(layer::setReading));
    followLegend(view);
    window.onSession(made -> setRegion(Optional.empty()));
    RegionTool regionTool = new RegionTool(this::sensor, this::setRegion);
    window.bindTool(measuring, tape);
    window.bindTool(drawingRegion, regionTool);
    window.bindTool(pointing, new PointTool());
    ViewerActions actions = window.actions();
    actions.add("measure", measuring);
    actions.add("region", drawingRegion);
    actions.add("point", pointing);
    actions.add("put-aside", this::putAside);
    actions.add("clear-region", () -> setRegion(Optional.empty()));
    actions.add("zoom-region", () -> layer.region().ifPresent(view::zoomTo));
    addZoom(view);
    ViewBar bar = window.panels().viewBar();
    bar.tool("tool-measure", Icons.TAPE, "Measure a length and an angle (T)", measuring);
    bar.tool("tool-region", Icons.REGION, "Draw the region of interest (G)", drawingRegion);
  }

  private void putAside() {
    EventView view = window.panels().view();
    if (view.tool().isPresent()) {
      view.setTool(Optional.empty());
    } else {
      window.status().clearError();
    }
  }

  private void addZoom(EventView view) {
    ViewerActions actions = window.actions();
    actions.add("zoom-in", () -> view.zoomBy(ZOOM_STEP));
    actions.add("zoom-out", () -> view.zoomBy(1 / ZOOM_STEP));
    actions.add("zoom-pixels", view::zoomToPixels);
    actions.add("pan-left", () -> view.pan(-PAN_STEP, 0));
    actions.add("pan-right", () -> view.pan(PAN_STEP, 0));
    actions.add("pan-up", () -> view.pan(0, PAN_STEP));
    actions.add("pan-down", () -> view.pan(0, -PAN_STEP));
  }

  private void followLegend(EventView view) {
    DisplayControl display = window.display();
    Runnable follow =
        () ->
            view.legend().configure(display.modeProperty().get(), display.gradientProperty().get());
    display.onChange(follow);
    follow.run();
  }

  private SensorGeometry sensor() {
    return window
        .sessions()
        .session()
        .map(open -> open.player().playable().geometry())
        .orElse(new SensorGeometry(1, 1));
  }

  /** Watches a region, or none. */
  public void setRegion(Optional<PixelRegion> region) {
    layer.setRegion(region);
    window.display().regionProperty().set(region);
    window.ifOpen(
        open -> {
          open.display().setRegion(region);
          open.player().refresh();
        });
    window.panels().view().redrawMarks();
  }

  /** What is shown of the region of interest. */
  RegionLayer region() {
    return layer;
  }

  /** The measuring tape. */
  MeasuringTape tape() {
    return tape;
  }
}
