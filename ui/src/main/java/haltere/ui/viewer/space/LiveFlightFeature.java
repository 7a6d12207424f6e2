package haltere.ui.viewer.space;

import haltere.core.camera.Cameras;
import haltere.core.format.ReadOptions;
import haltere.core.simulation.internal.flight.FlightSettings;
import haltere.filters.orientation.camera.CameraFile;
import haltere.filters.orientation.camera.CameraModel;
import haltere.ui.space.CameraRig;
import haltere.ui.space.LiveFlight;
import haltere.ui.viewer.action.ViewerActions;
import haltere.ui.viewer.feature.PanelLayout;
import haltere.ui.viewer.feature.WindowFeature;
import haltere.ui.viewer.session.SessionRequest;
import haltere.ui.viewer.session.ViewerSession;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;

/**
 * Position and axis of a body during playback of several cameras: a simulated flight, one recording
 * for each calibrated camera, or live cameras.
 */
public final class LiveFlightFeature extends WindowFeature {
  private final BooleanProperty linesShown = new SimpleBooleanProperty(true);
  private final LiveFlightPane pane = new LiveFlightPane(linesShown);
  private BooleanProperty shown;
  private Optional<CameraRig> rig = Optional.empty();
  private Optional<LiveFlight> flight = Optional.empty();

  @Override
  protected void install() {
    shown = window.addPanel("live-flight", PanelLayout.Position.BESIDE, () -> pane);
    ViewerActions actions = window.actions();
    actions.add("open-flight", this::openScene);
    actions.add("open-camera-recordings", () -> chooseCalibration(this::chooseRecordings));
    actions.add(
        "open-calibrated-cameras",
        () -> chooseCalibration(calibrated -> openCameras(calibrated, Cameras.installed())));
    actions.add("camera-lines", linesShown, () -> flight.isEmpty() ? "no flight is open" : "");
    window.settings().keep("space.cameraLines", linesShown);
    window.panels().view().addLayer(over -> pane.drawLine(0, over));
    linesShown.subscribe(() -> window.panels().view().redraw());
    window.display().onChange(() -> pane.setOptions(window.display().options()));
    window.sessions().onChange(this::follow);
    window.display().themeProperty().subscribe(pane::setTheme);
    window
        .panels()
        .onPulse(
            () ->
                flight
                    .filter(live -> pane.update(live.latest(), window.editor()::onProcessing))
                    .ifPresent(changed -> window.panels().view().redraw()));
  }

  /** Opens the simulated flight. */
  void openScene() {
    open(() -> CameraRig.simulated(FlightSettings.defaults()), "Flight");
  }

  /** Asks for the calibrated cameras. */
  private void chooseCalibration(Consumer<List<CameraModel>> chosen) {
    window
        .dialogs()
        .cameras()
        .ifPresent(file -> window.file(() -> CameraFile.read(file).cameras(), chosen));
  }

  private void chooseRecordings(List<CameraModel> cameras) {
    List<Path> files = new ArrayList<>();
    for (CameraModel camera : cameras) {
      window.status().setActivity("The recording of camera " + camera.id() + " \u2026");
      Optional<Path> file = window.dialogs().recording();
      window.status().setActivity("");
      if (file.isEmpty()) {
        return;
      }
      files.add(file.get());
    }
    openRecordings(cameras, files);
  }

  void openRecordings(List<CameraModel> cameras, List<Path> files) {
    open(
        () ->
            CameraRig.open(
                cameras, number -> SessionRequest.play(files.get(number), ReadOptions.DEFAULT)),
        files.get(0).toString());
  }

  void openCameras(List<CameraModel> calibrated, Cameras cameras) {
    open(() -> CameraRig.live(calibrated, cameras), "cameras");
  }

  /** Opens several cameras in place of the present source. */
  void open(Callable<CameraRig> cameras, String name) {
    window.file(
        cameras,
        made -> {
          rig.ifPresent(window.background()::close);
          rig = Optional.of(made);
          window.sessions().open(SessionRequest.made(made::first, name));
        });
  }

  private void follow(Optional<ViewerSession> was, Optional<ViewerSession> is) {
    was.ifPresent(before -> flight.ifPresent(before.player()::removeSink));
    flight = Optional.empty();
    boolean isFlight = rig.isPresent() && is.isPresent() && is.get().source() == rig.get().first();
    if (isFlight) {
      LiveFlight live =
          new LiveFlight(rig.get(), pane.reset(rig.get().others(), window.display().options()));
      is.get().player().addRawSink(live);
      flight = Optional.of(live);
    } else if (is.isPresent()) {
      rig.ifPresent(window.background()::close);
      rig = Optional.empty();
      pane.clear();
    }
    is.ifPresent(open -> shown.set(isFlight));
  }
}
