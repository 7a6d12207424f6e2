package haltere.ui.viewer.space;

import haltere.filters.orientation.camera.ObservationFile;
import haltere.ui.space.BodyFlight;
import haltere.ui.viewer.controls.Windows;
import haltere.ui.viewer.feature.ViewerContext;
import haltere.ui.viewer.feature.ViewerFeature;
import java.nio.file.Path;
import java.util.Optional;

/**
 * A window that shows a body in space from what several cameras saw of it: the observations of
 * {@code haltere orient} and its cameras are chosen one after the other.
 *
 * <p>Thread rule: JavaFX thread only.
 */
public final class BodyFlightFeature implements ViewerFeature {
  private ViewerContext window;

  @Override
  public void install(ViewerContext installed) {
    window = installed;
    window.actions().add("body-flight", this::choose);
  }

  private void choose() {
    Optional<Path> observations = window.dialogs().observations();
    observations.ifPresent(
        file ->
            window
                .background()
                .file(
                    () -> ObservationFile.hasCameras(file), own -> open(file, own), this::failed));
  }

  private void open(Path observations, boolean hasCameras) {
    Optional<Path> cameras = hasCameras ? Optional.empty() : window.dialogs().cameras();
    if (hasCameras || cameras.isPresent()) {
      window
          .background()
          .file(() -> BodyFlight.load(observations, cameras), this::show, this::failed);
    }
  }

  private void show(BodyFlight flight) {
    BodyFlightPane pane = new BodyFlightPane(flight);
    pane.setTheme(window.display().themeProperty().get());
    Windows.beside(window.stage(), "Orientation in space", pane, 800, 600).show();
  }

  private void failed(Exception problem) {
    window.status().showProblem(problem);
  }
}
