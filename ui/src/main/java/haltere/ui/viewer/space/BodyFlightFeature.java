package haltere.ui.viewer.space;

import haltere.filters.orientation.camera.ObservationFile;
import haltere.ui.space.BodyFlight;
import haltere.ui.viewer.controls.Windows;
import haltere.ui.viewer.feature.WindowFeature;
import java.nio.file.Path;
import java.util.Optional;

/**
 * A window of a body in space from the observations of several cameras. The user selects the
 * observations and the cameras, as for {@code haltere orient}.
 */
public final class BodyFlightFeature extends WindowFeature {
  @Override
  protected void install() {
    window.actions().add("body-flight", this::choose);
  }

  private void choose() {
    window
        .dialogs()
        .open(
            "Open observations of several cameras",
            "Observations",
            "*.csv",
            "*.braidz",
            "*.h5",
            "*.hdf5")
        .ifPresent(
            file -> window.file(() -> ObservationFile.hasCameras(file), own -> open(file, own)));
  }

  private void open(Path observations, boolean hasCameras) {
    Optional<Path> cameras = hasCameras ? Optional.empty() : window.dialogs().cameras();
    if (hasCameras || cameras.isPresent()) {
      window.file(() -> BodyFlight.load(observations, cameras), this::show);
    }
  }

  private void show(BodyFlight flight) {
    BodyFlightPane pane = new BodyFlightPane(flight, window.display().themeProperty().get());
    Windows.beside(window.stage(), "Orientation in space", pane, 800, 600).show();
  }
}
