package haltere.ui.viewer;

import haltere.core.event.SensorGeometry;
import haltere.filters.frequency.PixelRegion;
import haltere.ui.viewer.action.ViewerAction;
import haltere.ui.viewer.feature.DisplayControl;
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
  private static final String MENU = "Tools";
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
    window.add(
        ViewerAction.toggle("measure", "Measuring tape", MENU, measuring)
            .withKey("T")
            .withHelp(tape.hint()),
        ViewerAction.toggle("region", "Region of interest", MENU, drawingRegion)
            .withKey("G")
            .withHelp("Its event rate and dominant frequency are shown beside it."),
        ViewerAction.toggle("point", "Point with the keys", MENU, pointing)
            .withKey("C")
            .withHelp("Arrow keys move a cross; its pixel is described as one under the mouse."),
        ViewerAction.of("put-aside", "Dismiss the tool or the message", MENU, this::putAside)
            .withKey("Esc"),
        ViewerAction.of(
            "clear-region",
            "Clear the region of interest",
            MENU,
            () -> setRegion(Optional.empty())),
        ViewerAction.of(
            "zoom-region",
            "Zoom to the region of interest",
            MENU,
            () -> layer.region().ifPresent(view::zoomTo)));
    addZoom(view);
    window.panels().viewBar().addTools(measuring, drawingRegion);
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
    window.add(
        ViewerAction.of("zoom-in", "Zoom in", "View", () -> view.zoomBy(ZOOM_STEP))
            .withKey("Shortcut+Plus"),
        ViewerAction.of("zoom-out", "Zoom out", "View", () -> view.zoomBy(1 / ZOOM_STEP))
            .withKey("Shortcut+Minus"),
        ViewerAction.of("zoom-pixels", "Zoom to single pixels", "View", view::zoomToPixels)
            .withKey("P"),
        ViewerAction.of("pan-left", "Pan left", "View", () -> view.pan(-PAN_STEP, 0))
            .withKey("Alt+Left"),
        ViewerAction.of("pan-right", "Pan right", "View", () -> view.pan(PAN_STEP, 0))
            .withKey("Alt+Right"),
        ViewerAction.of("pan-up", "Pan up", "View", () -> view.pan(0, PAN_STEP)).withKey("Alt+Up"),
        ViewerAction.of("pan-down", "Pan down", "View", () -> view.pan(0, -PAN_STEP))
            .withKey("Alt+Down"));
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
