package haltere.ui.viewer;

import haltere.core.event.SensorGeometry;
import haltere.filters.frequency.PixelRegion;
import haltere.filters.frequency.RegionMeasurement;
import haltere.ui.viewer.action.ViewerActions;
import haltere.ui.viewer.controls.Icons;
import haltere.ui.viewer.feature.DisplayControl;
import haltere.ui.viewer.feature.ViewBar;
import haltere.ui.viewer.feature.WindowFeature;
import haltere.ui.viewer.picture.EventView;
import haltere.ui.viewer.picture.MeasuringTape;
import haltere.ui.viewer.picture.RegionMarks;
import haltere.ui.viewer.picture.RegionTool;
import haltere.ui.viewer.picture.ViewTool;
import haltere.ui.viewer.session.ViewerSession;
import java.util.Optional;
import java.util.function.Supplier;
import javafx.animation.PauseTransition;
import javafx.beans.property.BooleanProperty;
import javafx.util.Duration;

/** Inspection: the pixel under the mouse, a region of interest, the measuring tape, zoom. */
public final class InspectionFeature extends WindowFeature {
  private static final double ZOOM_STEP = 1.5;
  private static final double PAN_STEP = 0.1;

  /** Time at a pixel before a pause measures the rate around it. */
  private final PauseTransition rest = new PauseTransition(Duration.millis(150));

  private RegionMeasurement reading = RegionMeasurement.NOTHING;

  @Override
  protected void install() {
    EventView view = window.panels().view();
    view.pointedProperty().subscribe((was, is) -> point(is));
    rest.setOnFinished(event -> window.refresh(open -> {}));
    view.addLayer(canvas -> region().ifPresent(marks -> marks.draw(canvas)));
    view.onFrame(frame -> reading = frame.region().orElse(reading));
    followLegend(view);
    window.onSession(
        made -> {
          setRegion(Optional.empty());
          point(view.pointedProperty().get());
        });
    ViewTool tape = new MeasuringTape(window.display().tapeProperty());
    BooleanProperty measuring = window.addTool("measure", tape, () -> "");
    RegionTool regionTool = new RegionTool(this::sensor, this::setRegion);
    BooleanProperty drawingRegion = window.addTool("region", regionTool, () -> "");
    // pixels are selected by keys, for users without a mouse
    ViewTool pointing = () -> "The pixel at the cross is described below the picture.";
    window.addTool("point", pointing, () -> "");
    ViewerActions actions = window.actions();
    actions.add("put-aside", this::dismiss);
    Supplier<String> noRegion = () -> region().isEmpty() ? "no region is drawn" : "";
    actions.add("clear-region", () -> setRegion(Optional.empty()), noRegion);
    actions.add(
        "zoom-region",
        () -> region().map(RegionMarks::region).ifPresent(view.viewpoint()::zoomTo),
        noRegion);
    addZoom(view);
    ViewBar bar = window.panels().viewBar();
    bar.tool("tool-measure", Icons.TAPE, "Measure a length and an angle (T)", measuring);
    bar.tool("tool-region", Icons.REGION, "Draw the region of interest (G)", drawingRegion);
  }

  private void point(Optional<PixelRegion> pixel) {
    window.ifOpen(open -> open.display().renderer().point(pixel));
    rest.playFromStart();
  }

  private void dismiss() {
    EventView view = window.panels().view();
    if (view.tool().filter(ViewTool::takeBack).isPresent()) {
      view.redraw();
    } else if (view.tool().isPresent()) {
      view.setTool(Optional.empty());
    } else {
      window.status().clearError();
    }
  }

  private void addZoom(EventView view) {
    ViewerActions actions = window.actions();
    actions.add("zoom-in", () -> view.viewpoint().zoomBy(ZOOM_STEP));
    actions.add("zoom-out", () -> view.viewpoint().zoomBy(1 / ZOOM_STEP));
    actions.add("zoom-pixels", view::zoomToPixels);
    actions.add("pan-left", () -> view.viewpoint().pan(-PAN_STEP, 0));
    actions.add("pan-right", () -> view.viewpoint().pan(PAN_STEP, 0));
    actions.add("pan-up", () -> view.viewpoint().pan(0, PAN_STEP));
    actions.add("pan-down", () -> view.viewpoint().pan(0, -PAN_STEP));
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
    Optional<ViewerSession> open = window.sessions().session();
    return open.map(it -> it.player().playable().geometry()).orElse(new SensorGeometry(1, 1));
  }

  /** Watches a region, or none. */
  public void setRegion(Optional<PixelRegion> region) {
    reading = RegionMeasurement.NOTHING;
    window.display().regionProperty().set(region);
    window.refresh(open -> open.display().renderer().setRegion(region));
    window.panels().view().redraw();
  }

  /** The shown region of interest. */
  Optional<RegionMarks> region() {
    return window.display().regionProperty().get().map(pixels -> new RegionMarks(pixels, reading));
  }
}
